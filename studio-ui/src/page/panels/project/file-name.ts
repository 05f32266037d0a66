import { fileName } from "../take-away/making";

/** A name for the file of a project. */
export const projectFileName = (title: string): string => fileName(title || "studio", "project.json");

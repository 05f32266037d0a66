// Where to read more of a term: the page of the guide, where the guide lies beside the page; else which page that is.
import type { GlossaryTerm } from "../lib/terms";
import { useStore } from "./context";
import { Icon } from "./icon";

/** The address of a page of the guide, "course/bracket.md#more", beside this page. */
export const guideAddress = (page: string): string => `guide/${page.replace(/\.md(?=#|$)/, ".html")}`;

export function GuideLink({ entry: { guide, page } }: { entry: GlossaryTerm }) {
  const { front } = useStore();
  if (!front.guide.value) return <span class="in-guide">In the guide: {guide}</span>;
  return (
    <a class="in-guide" href={guideAddress(page)} target="_blank" rel="noopener" data-testid="guide-link">
      In the guide: {guide}
      <Icon name="link" size={12} />
    </a>
  );
}

// What lies over the page: the list of commands, that of keys, and a short notice.
import { useStore } from "../parts/context";
import { Glossary } from "./glossary";
import { KeyList } from "./key-list";
import { Palette } from "./palette";
import { Repeat } from "./repeat";
import { TermTip } from "./term-tip";
import { TourCard } from "./tour";
import "./front.css";
import "./repeat.css";
import "./terms.css";

export function Front() {
  const { dialog, notice } = useStore().front;
  const close = () => void (dialog.value = null);
  return (
    <>
      {dialog.value === "palette" && <Palette onClose={close} />}
      {dialog.value === "keys" && <KeyList onClose={close} />}
      {dialog.value === "glossary" && <Glossary onClose={close} />}
      {dialog.value === "repeat" && <Repeat onClose={close} />}
      <TermTip />
      <TourCard />
      <div class={notice.value ? "notice told" : "notice"} role="status" data-testid="notice">
        {notice.value}
      </div>
    </>
  );
}

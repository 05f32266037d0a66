// Report, derivation, figures, data and a link, to take away.
import { Embed } from "./take-away/embed";
import { Link } from "./take-away/link";
import { SECTIONS } from "./take-away/formats";
import { OfferRow } from "./take-away/offer";
import type { PanelProps } from "./index";
import "./take-away/take-away.css";

export function TakeAway({ store }: PanelProps) {
  const study = store.study.value;
  if (!study) return null;
  return (
    <div class="take-away">
      <header>
        <h2>Take away</h2>
        <p class="why">Everything is made on this machine, for the pose that is shown.</p>
      </header>
      {SECTIONS.map(({ title, offers }) => (
        <section key={title}>
          <h3>{title}</h3>
          <ul class="offers">
            {offers.map((offer) => (
              <OfferRow key={offer.thing} offer={offer} />
            ))}
          </ul>
        </section>
      ))}
      <Link />
      <Embed />
    </div>
  );
}

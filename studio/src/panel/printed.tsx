// The last line on paper: when it was printed, and the link to the mission. On the screen it is not to be seen.
import { useEffect, useState } from "preact/hooks";
import { onPrinting } from "../map/viewport/printing";

interface Imprint {
  when: string;
  link: string;
}

export function Printed({ linked }: { linked: boolean }) {
  const [imprint, setImprint] = useState<Imprint | null>(null);
  useEffect(() => onPrinting((printing) => setImprint(printing ? imprintNow() : null)), []);
  if (!imprint) return null;
  return (
    <footer class="printed">
      Printed on {imprint.when}
      {linked && (
        <>
          {" from "}
          <a href={imprint.link}>{isReadable(imprint.link) ? imprint.link : "this link"}</a>
        </>
      )}
    </footer>
  );
}

function imprintNow(): Imprint {
  return { when: new Date().toLocaleString("en-GB", { dateStyle: "long", timeStyle: "short" }), link: location.href };
}

// Nobody types the others; in a PDF they can be followed.
function isReadable(link: string): boolean {
  return link.length <= 300;
}

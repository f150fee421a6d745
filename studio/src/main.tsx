import { render } from "preact";

render(<main>waybreaker</main>, document.getElementById("app")!);

import { render } from "preact";
import "./style.css";

render(<main>waybreaker</main>, document.getElementById("app")!);

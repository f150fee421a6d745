import { httpReference } from "../openapi.mjs";

export default { paths: () => [{ params: { api: "http" }, content: httpReference() }] };

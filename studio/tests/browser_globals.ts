// What every browser has as a global and Debian's Node 18 has only in a module.
import { File } from "node:buffer";

Object.assign(globalThis, { File });

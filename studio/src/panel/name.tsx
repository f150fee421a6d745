// A name among words: of whatever script and length, it changes nothing of what stands around it.
import { plainName } from "../domain/plain_name";

export function Name({ of }: { of: string }) {
  return <bdi class="name">{plainName(of)}</bdi>;
}

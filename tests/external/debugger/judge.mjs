// What the published protocol says of a message: its types, as @vscode/debugprotocol has them, turned into schemas.
// What the types do not name is refused as well.

import { createRequire } from 'node:module';
import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import Ajv from 'ajv';
import { createGenerator } from 'ts-json-schema-generator';

const require = createRequire(import.meta.url);
const types = require.resolve('@vscode/debugprotocol/lib/debugProtocol.d.ts');
const folder = mkdtempSync(join(tmpdir(), 'tip-debugger-'));
// The namespace is not a module that the generator can name types of.
const entry = join(folder, 'entry.ts');
const capital = (name) => name[0].toUpperCase() + name.slice(1);
const validators = new Map();

function validator(type) {
  if (!validators.has(type)) {
    writeFileSync(entry, `import { DebugProtocol } from '${types.replace('.d.ts', '')}';\nexport type Judged = DebugProtocol.${type};\n`);
    const schema = createGenerator({ path: entry, type: 'Judged', skipTypeCheck: true, additionalProperties: false }).createSchema('Judged');
    validators.set(type, new Ajv({ allowUnionTypes: true, strict: false }).compile(schema));
  }
  return validators.get(type);
}

// What is wrong with a message; nothing if it is right.
export function judge(message) {
  const type = message.type === 'event'
    ? `${capital(message.event)}Event`
    : message.success ? `${capital(message.command)}Response` : 'ErrorResponse';
  const valid = validator(type);
  return valid(message) ? [] : valid.errors.map((error) => `${type}${error.instancePath}: ${error.message}`);
}

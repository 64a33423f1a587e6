// node validate.mjs FOLDER FILE...: see validate.sh.
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { basename, resolve } from 'node:path';

const [folder, ...files] = process.argv.slice(2);
const validator = createRequire(resolve(folder) + '/')('gltf-validator');
const names = ['error', 'warning'];
let errors = 0;
for (const file of files) {
    const report = await validator.validateBytes(new Uint8Array(await readFile(file)), { uri: basename(file), maxIssues: 1000 });
    // Below warnings it tells of unused objects, and that it does not know MOZ_lightmap.
    for (const { severity, code, message, pointer } of report.issues.messages.filter((issue) => issue.severity <= 1)) {
        console.log(`${file}: ${names[severity]}: ${code}: ${message} ${pointer ?? ''}`);
    }
    console.log(`${file}: ${report.issues.numErrors} errors, ${report.issues.numWarnings} warnings`);
    errors += report.issues.numErrors;
}
process.exit(errors > 0 ? 1 : 0);

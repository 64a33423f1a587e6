// node validate.mjs FOLDER FILE...: see validate.sh.
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { basename, resolve } from 'node:path';

const [folder, ...files] = process.argv.slice(2);
const validator = createRequire(resolve(folder) + '/')('gltf-validator');
let errors = 0;
for (const file of files) {
    const report = await validator.validateBytes(new Uint8Array(await readFile(file)), { uri: basename(file), maxIssues: 1000 });
    // The rest is talk: unused objects, MOZ_lightmap unknown to it, what the source had already.
    for (const { code, message, pointer } of report.issues.messages.filter((issue) => issue.severity === 0)) {
        console.log(`${file}: error: ${code}: ${message} ${pointer ?? ''}`);
    }
    console.log(`${file}: ${report.issues.numErrors} errors, ${report.issues.numWarnings} warnings`);
    errors += report.issues.numErrors;
}
process.exit(errors > 0 ? 1 : 0);

// The client of `tip dap`.
import * as vscode from 'vscode';
import { savedProgram, tip } from './tip.js';

export function register(context) {
  context.subscriptions.push(
    vscode.debug.registerDebugAdapterDescriptorFactory('tip', {
      async createDebugAdapterDescriptor() {
        const command = await tip();
        return command && new vscode.DebugAdapterExecutable(command, ['dap']);
      },
    }),
    vscode.debug.registerDebugConfigurationProvider('tip', { resolveDebugConfiguration: complete }),
    vscode.commands.registerCommand('tip.debug', async (uri) => {
      const file = await savedProgram(uri);
      if (!file) return undefined;
      const folder = vscode.workspace.getWorkspaceFolder(file);
      return vscode.debug.startDebugging(folder, launch(file.fsPath));
    }),
  );
}

function launch(program) {
  return { type: 'tip', request: 'launch', name: 'T.I.P.', program, stopOnEntry: true };
}

/** What a launch leaves open; without launch.json, all of it. */
async function complete(folder, given) {
  const editor = vscode.window.activeTextEditor;
  const isBare = !given.type && !given.request;
  const config = isBare && editor?.document.languageId === 'tip' ? launch('${file}') : given;
  if (!config.program) {
    vscode.window.showErrorMessage(vscode.l10n.t('There is no program to debug: open one, or name it in launch.json.'));
    return undefined;
  }
  // tip() has shown a message already.
  if ((await tip()) === undefined) return undefined;
  const robot = vscode.workspace.getConfiguration('tip', folder?.uri).get('robot');
  return robot && !config.robot ? { ...config, robot } : config;
}

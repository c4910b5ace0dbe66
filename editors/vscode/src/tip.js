// The command `tip` of the settings, with a message if it is missing, and programs that are saved before they run.
import * as vscode from 'vscode';
import { cargoFolder, find } from './command.js';

/** Returns the path of the command; undefined after a message to the user if there is none. */
export async function tip() {
  const setting = vscode.workspace.getConfiguration('tip').get('path', '');
  const { path, reason } = await find(setting, vscode.workspace.workspaceFolders?.[0]?.uri.fsPath);
  if (path === undefined) complain(setting, reason);
  return path;
}

/** Saves the program of a button or of the active editor; undefined if the user cancels. */
export async function savedProgram(uri) {
  const program = uri ?? vscode.window.activeTextEditor?.document.uri;
  return program && vscode.workspace.save(program);
}

async function complain(setting, reason) {
  const { t } = vscode.l10n;
  const name = setting || 'tip';
  const missing = setting
    ? t('There is no command {0}, which the setting tip.path names. Correct the setting, or clear it to search PATH and {1}.', setting, cargoFolder())
    : t('The command tip was not found on PATH or in {0}. To install it, run “cargo install --path tools/cli” in a checkout of T.I.P.; if it is in another folder, set tip.path. Diagnostics, completion, runs and debugging need it.', cargoFolder());
  const texts = {
    missing,
    other: t('{0} is another program, not the command tip of T.I.P. Set tip.path to the command of T.I.P.; Cargo installs it in {1}.', name, cargoFolder()),
  };
  const [install, choose] = [t('How to Install'), t('Choose the File…')];
  const text = texts[reason] ?? t('{0} does not start: {1}', name, reason);
  const answer = await vscode.window.showErrorMessage(text, install, choose);
  if (answer === install) await showInstallation();
  if (answer === choose) await chooseFile();
}

async function showInstallation() {
  const { extensionUri } = vscode.extensions.getExtension('tip.tip');
  // The package has the English file in small letters.
  const file = vscode.env.language.startsWith('ja') ? 'README.ja.md' : 'readme.md';
  await vscode.commands.executeCommand('markdown.showPreview', vscode.Uri.joinPath(extensionUri, file));
}

async function chooseFile() {
  const [file] = (await vscode.window.showOpenDialog({ canSelectMany: false })) ?? [];
  if (!file) return;
  const settings = vscode.workspace.getConfiguration('tip');
  await settings.update('path', file.fsPath, vscode.ConfigurationTarget.Global);
}

// What runs and debugging need: the command `tip` of this editor's settings, and a program that is saved.
import * as vscode from 'vscode';
import { find } from './command.js';

/** The path of the command; nothing if there is none, after a message to the user. */
export async function tip() {
  const setting = vscode.workspace.getConfiguration('tip').get('path', '');
  const { path, reason } = await find(setting, vscode.workspace.workspaceFolders?.[0]?.uri.fsPath);
  if (path === undefined) complain(setting, reason);
  return path;
}

/** The program of a button, or of the editor in front, once it is saved; nothing if the user would not. */
export async function savedProgram(uri) {
  const program = uri ?? vscode.window.activeTextEditor?.document.uri;
  return program && vscode.workspace.save(program);
}

async function complain(setting, reason) {
  const { t } = vscode.l10n;
  const name = setting || 'tip';
  const why = {
    missing: t('The command {0} is not found. Findings, completion, runs and debugging need it.', name),
    other: t('{0} is another program, not the command tip of T.I.P.', name),
  };
  const [install, choose] = [t('How to Install'), t('Choose the File…')];
  const text = why[reason] ?? t('{0} does not start: {1}', name, reason);
  const answer = await vscode.window.showErrorMessage(text, install, choose);
  if (answer === install) await showInstallation();
  if (answer === choose) await chooseFile();
}

async function showInstallation() {
  const { extensionUri } = vscode.extensions.getExtension('tip.tip');
  // The package spells the first one so.
  const file = vscode.env.language.startsWith('ja') ? 'README.ja.md' : 'readme.md';
  await vscode.commands.executeCommand('markdown.showPreview', vscode.Uri.joinPath(extensionUri, file));
}

async function chooseFile() {
  const [file] = (await vscode.window.showOpenDialog({ canSelectMany: false })) ?? [];
  if (!file) return;
  const settings = vscode.workspace.getConfiguration('tip');
  await settings.update('path', file.fsPath, vscode.ConfigurationTarget.Global);
}

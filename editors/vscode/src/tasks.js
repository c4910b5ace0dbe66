// Runs and traces in a terminal, and commands of tip as tasks.
import { basename, dirname } from 'node:path';
import * as vscode from 'vscode';
import { runArguments, traceArguments, traceOf } from './arguments.js';
import { savedProgram, tip } from './tip.js';

export function register(context) {
  context.subscriptions.push(
    vscode.tasks.registerTaskProvider('tip', {
      provideTasks: () => [],
      resolveTask: async (task) => {
        const { command, args = [] } = task.definition;
        return made(task.definition, task.scope, [command, ...args], '${workspaceFolder}');
      },
    }),
    vscode.commands.registerCommand('tip.run', (uri) => started(uri, runArguments)),
    vscode.commands.registerCommand('tip.trace', async (uri) => {
      const file = await started(uri, traceArguments, true);
      if (file) await vscode.window.showTextDocument(vscode.Uri.file(traceOf(file)), { preview: true });
    }),
  );
}

/** Starts a program; its file, once it runs or, if so asked, has ended well. */
async function started(uri, argumentsOf, untilEnd = false) {
  const saved = await savedProgram(uri);
  if (!saved) return undefined;
  const file = saved.fsPath;
  const settings = vscode.workspace.getConfiguration('tip', saved);
  const args = argumentsOf(file, (name) => settings.get(name));
  const scope = vscode.workspace.getWorkspaceFolder(saved) ?? vscode.TaskScope.Workspace;
  const task = await made({ type: 'tip', command: args[0], args: args.slice(1) }, scope, args, dirname(file), basename(file));
  if (!task) return undefined;
  const execution = await vscode.tasks.executeTask(task);
  if (!untilEnd) return file;
  return (await ended(execution)) === 0 ? file : undefined;
}

async function made(definition, scope, args, cwd, name = args.slice(1).join(' ')) {
  const command = await tip();
  if (command === undefined) return undefined;
  const execution = new vscode.ProcessExecution(command, args, { cwd });
  const task = new vscode.Task(definition, scope, `${args[0]} ${name}`, 'tip', execution, '$tip');
  // The program's keys are those of the terminal.
  task.presentationOptions = { clear: true, focus: true, panel: vscode.TaskPanelKind.Dedicated };
  return task;
}

function ended(execution) {
  return new Promise((resolve) => {
    const watch = vscode.tasks.onDidEndTaskProcess((event) => {
      if (event.execution !== execution) return;
      watch.dispose();
      resolve(event.exitCode);
    });
  });
}

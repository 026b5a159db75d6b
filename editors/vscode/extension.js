// Starts `kane lsp` for Markdown documents. Everything else is the server's.
"use strict";

const { commands, window, workspace } = require("vscode");
const { LanguageClient, TransportKind } = require("vscode-languageclient/node");

let client;

async function start() {
  const command = workspace.getConfiguration("kane").get("path") || "kane";
  client = new LanguageClient(
    "kane",
    "Kane",
    { command, args: ["lsp"], transport: TransportKind.stdio },
    { documentSelector: [{ language: "markdown" }] },
  );
  try {
    await client.start();
  } catch (error) {
    client = undefined;
    window.showErrorMessage(
      `Kane: \`${command} lsp\` does not start (${error.message}). The setting kane.path says where the program is.`,
    );
  }
}

async function stop() {
  const running = client;
  client = undefined;
  if (running) {
    await running.stop();
  }
}

async function activate(context) {
  const restart = async () => {
    await stop();
    await start();
  };
  context.subscriptions.push(
    commands.registerCommand("kane.restart", restart),
    workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration("kane.path")) {
        return restart();
      }
    }),
  );
  await start();
}

module.exports = { activate, deactivate: stop };

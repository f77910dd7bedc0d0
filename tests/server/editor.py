"""An editor: keeps texts as a client does, counts columns by itself, and speaks with a server."""

from __future__ import annotations

import asyncio
import sysconfig
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from types import SimpleNamespace

from lsprotocol import types
from pygls.protocol import default_converter
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities
from pytest_lsp.client import DEFAULT_CLIENT_FEATURES

KINLINT = str(Path(sysconfig.get_path("scripts"), "kinlint"))
CODECS = {"utf-8": "utf-8", "utf-16": "utf-16-le", "utf-32": "utf-32-le"}
WIDTHS = {"utf-8": 1, "utf-16": 2, "utf-32": 4}
PROFILES = ("visual-studio-code", "neovim", "emacs")
PATIENCE = 240
"""Seconds after which an answer is said to be missing, on the slowest of machines."""


async def started(profile, env, command=(KINLINT, "server", "--stdio")):
    """A client with a server that it has not spoken with."""
    command = [KINLINT, "server", "--stdio"]
    client = await ClientServerConfig(command, client_factory=made, server_env=env).start()
    return client, client_capabilities(profile)


def made():
    """A client that remembers what it is told, with the versions that it is about."""
    client = LanguageClient(converter_factory=default_converter)
    client.published, client.news = {}, asyncio.Event()
    client.applied, client.watched, client.complaint = [], [], asyncio.Event()

    def publish(params):
        client.published[params.uri] = params
        client.news.set()

    def refresh(_):
        client.diagnostic_refresh_count += 1
        client.news.set()

    def complain(params):
        client.messages.append(params)
        client.complaint.set()

    def apply(params):
        client.applied.append(params.edit)
        return types.ApplyWorkspaceEditResult(applied=True)

    def register(params):
        client.watched += params.registrations

    handlers = {
        types.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS: publish,
        types.WORKSPACE_DIAGNOSTIC_REFRESH: refresh,
        types.WINDOW_SHOW_MESSAGE: complain,
        types.WORKSPACE_APPLY_EDIT: apply,
        types.CLIENT_REGISTER_CAPABILITY: register,
    }
    defaults = {name: partial(handler, client) for name, handler in DEFAULT_CLIENT_FEATURES.items()}
    for name, handler in {**defaults, **handlers}.items():
        client.feature(name)(handler)
    return client


class Editor:
    """A client of one of the profiles, in a folder."""

    def __init__(self, client, capabilities, here):
        self.client, self.capabilities, self.here = client, capabilities, here
        self.texts, self.versions, self.encoding = {}, {}, "utf-16"

    async def begin(self, folders=None, options=None):
        """Say hello; the workspace is the folder unless *folders* are given."""
        self.folders = [self.here] if folders is None else folders
        self.said = await self.client.initialize_session(
            types.InitializeParams(
                capabilities=self.capabilities,
                workspace_folders=[
                    types.WorkspaceFolder(Path(one).as_uri(), Path(one).name)
                    for one in self.folders
                ],
                initialization_options=options,
            )
        )
        self.encoding = self.said.capabilities.position_encoding
        self.pulls = self.said.capabilities.diagnostic_provider is not None
        return self

    @contextmanager
    def in_one_piece(self):
        """Send what the block says when it ends, so that the server hears it without a pause."""
        protocol = self.client.protocol
        writer, said = protocol.writer, []
        protocol.set_writer(SimpleNamespace(write=said.append))
        yield
        protocol.set_writer(writer)
        writer.write(b"".join(said))

    def uri(self, name):
        return (self.here / name).as_uri()

    def write(self, name, text):
        path = self.here / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode())
        return path

    def open(self, name, text=None, language="xml"):
        """Open a file, or a text that is not saved yet."""
        text = (self.here / name).read_bytes().decode() if text is None else text
        self.texts[name], self.versions[name] = text, 1
        item = types.TextDocumentItem(self.uri(name), language, 1, text)
        self.client.text_document_did_open(types.DidOpenTextDocumentParams(item))

    def replace(self, name, old, new):
        """Type *new* over the first *old*, which the server is told as a change of a range."""
        text = self.texts[name]
        start = text.index(old)
        place = types.Range(self.position(text, start), self.position(text, start + len(old)))
        self.change(name, types.TextDocumentContentChangePartial(place, new))
        self.texts[name] = text.replace(old, new, 1)

    def rewrite(self, name, text):
        """Put *text* in the place of all."""
        self.change(name, types.TextDocumentContentChangeWholeDocument(text))
        self.texts[name] = text

    def change(self, name, *changes):
        self.versions[name] += 1
        which = types.VersionedTextDocumentIdentifier(self.versions[name], self.uri(name))
        self.client.text_document_did_change(types.DidChangeTextDocumentParams(which, changes))

    def save(self, name):
        self.write(name, self.texts[name])
        which = types.TextDocumentIdentifier(self.uri(name))
        self.client.text_document_did_save(types.DidSaveTextDocumentParams(which))

    def close(self, name):
        del self.texts[name], self.versions[name]
        which = types.TextDocumentIdentifier(self.uri(name))
        self.client.text_document_did_close(types.DidCloseTextDocumentParams(which))

    def touched(self, *names):
        """Tell that files changed on disk."""
        kind = types.FileChangeType.Changed
        events = [types.FileEvent(self.uri(name), kind) for name in names]
        self.client.workspace_did_change_watched_files(types.DidChangeWatchedFilesParams(events))

    async def diagnostics(self, name, until=lambda _: True):
        """What the server says of the newest text, once it satisfies *until*."""
        return await asyncio.wait_for(self._diagnostics(name, until), PATIENCE)

    async def _diagnostics(self, name, until):
        uri = self.uri(name)
        while True:
            self.client.news.clear()
            if self.pulls:
                which = types.TextDocumentIdentifier(uri)
                params = types.DocumentDiagnosticParams(which)
                items = (await self.client.text_document_diagnostic_async(params)).items
                if until(items):
                    return items
                await asyncio.wait([asyncio.ensure_future(self.client.news.wait())], timeout=0.2)
            else:
                told = self.client.published.get(uri)
                if told and told.version == self.versions.get(name) and until(told.diagnostics):
                    return told.diagnostics
                await self.client.news.wait()

    async def codes(self, name, until=lambda _: True):
        """The codes of the diagnostics of *name*, in the order of the text."""
        found = await self.diagnostics(
            name, lambda items: until(sorted(one.code or "" for one in items))
        )
        return sorted(one.code or "" for one in found)

    def marked(self, name, diagnostic):
        """The text that *diagnostic* marks."""
        return self.at(self.texts[name], diagnostic.range)

    def at(self, text, place):
        return text[self.offset(text, place.start) : self.offset(text, place.end)]

    def position(self, text, offset):
        """The place of *offset*: lines end with LF, CRLF or CR, and with nothing else."""
        before = text[:offset].replace("\r\n", "\0\n").replace("\r", "\n").replace("\0\n", "\r\n")
        line = before.count("\n")
        head = text[:offset][before.rfind("\n") + 1 :]
        return types.Position(line, self.units(head))

    def units(self, text):
        return len(text.encode(CODECS[self.encoding])) // WIDTHS[self.encoding]

    def offset(self, text, position):
        """The offset of *position*, found by trying."""
        starts = [0]
        for index, char in enumerate(text):
            if char == "\n" or (char == "\r" and text[index + 1 : index + 2] != "\n"):
                starts.append(index + 1)
        at = starts[position.line]
        while self.units(text[starts[position.line] : at]) < position.character:
            at += 1
        return at

    async def actions(self, name, mark, only=("quickfix",), diagnostics=()):
        """The code actions of the kinds *only* where *mark* stands first."""
        text = self.texts[name]
        start = text.index(mark)
        place = types.Range(self.position(text, start), self.position(text, start + len(mark)))
        params = types.CodeActionParams(
            types.TextDocumentIdentifier(self.uri(name)),
            place,
            types.CodeActionContext(list(diagnostics), only),
        )
        return await self.client.text_document_code_action_async(params) or []

    async def resolved(self, action):
        return await self.client.code_action_resolve_async(action)

    def applied(self, edit):
        """The texts after *edit*, by name, provided that the versions are those of now."""
        texts = {}
        if edit.document_changes is None:
            changes = edit.changes.items()
        else:
            changes = [(one.text_document.uri, one.edits) for one in edit.document_changes]
            for one in edit.document_changes:
                known = {self.uri(name): number for name, number in self.versions.items()}
                assert one.text_document.version == known.get(one.text_document.uri)
        for uri, edits in changes:
            name = next(one for one in self._names() if self.uri(one) == uri)
            text = self.texts.get(name) or (self.here / name).read_bytes().decode()
            spans = [
                (self.offset(text, one.range.start), self.offset(text, one.range.end), one.new_text)
                for one in edits
            ]
            for start, end, new in sorted(spans, reverse=True):
                text = text[:start] + new + text[end:]
            texts[name] = text
        return texts

    def _names(self):
        files = (one for one in self.here.rglob("*") if one.is_file())
        return {*self.texts, *(str(one.relative_to(self.here)) for one in files)}

    async def command(self, name, *arguments):
        params = types.ExecuteCommandParams(command=name, arguments=list(arguments))
        return await self.client.workspace_execute_command_async(params)

"""Initialize, shutdown and exit: capabilities, settings and watched files of the client."""

from __future__ import annotations

import asyncio
import os
from collections.abc import Iterable
from pathlib import Path

from lsprotocol import types

from kinlint.configuration.config_file import NAMES
from kinlint.formats.records import GLOBBED
from kinlint.server import publish_diagnostics, pull_diagnostics
from kinlint.server.app import KinlintServer
from kinlint.server.buffers import path_of
from kinlint.server.client_settings import ClientSettings
from kinlint.server.working_directory import work_in

SECTION = "kinlint"
WATCHED = (
    *(f"**/{name}" for name in NAMES),
    "**/*{" + ",".join(GLOBBED) + "}",
)
"""Configuration, and whatever may be a model, a rule or a context."""
PULSE = 3.0
"""Every so many seconds the server looks whether the client still is there."""


def register(server: KinlintServer) -> None:
    """Answer to what clients say at the beginning, and of their workspace from then on."""

    @server.feature(types.INITIALIZE)
    def initialize(params: types.InitializeParams) -> None:
        server.roots = _roots(params)
        work_in(server.roots)
        server.preferences = ClientSettings.from_json(params.initialization_options)
        known = params.capabilities.text_document
        (pull_diagnostics if known and known.diagnostic else publish_diagnostics).register(server)
        if params.process_id:
            server.watch = asyncio.ensure_future(_outlive_nobody(params.process_id))

    @server.feature(types.INITIALIZED)
    async def initialized(_params: types.InitializedParams) -> None:
        server.use_settings(server.preferences)
        await _register(server)
        await _ask(server)

    @server.feature(types.SHUTDOWN)
    def shutdown(_params: None) -> None:
        server.shut_down(asked=True)

    @server.feature(types.WORKSPACE_DID_CHANGE_CONFIGURATION)
    async def configure(params: types.DidChangeConfigurationParams) -> None:
        if _can_be_asked(server):
            await _ask(server)
        else:
            server.use_settings(ClientSettings.from_json(params.settings))

    @server.feature(types.WORKSPACE_DID_CHANGE_WATCHED_FILES)
    def watched(_params: types.DidChangeWatchedFilesParams) -> None:
        server.changed(disk=True)

    @server.feature(types.WORKSPACE_DID_CHANGE_WORKSPACE_FOLDERS)
    def folders(_params: types.DidChangeWorkspaceFoldersParams) -> None:
        server.roots = _paths(folder.uri for folder in server.workspace.folders.values())
        server.changed(disk=True)


def _roots(params: types.InitializeParams) -> tuple[Path, ...]:
    if params.workspace_folders:
        return _paths(folder.uri for folder in params.workspace_folders)
    if params.root_uri:
        return _paths([params.root_uri])
    return (Path(params.root_path),) if params.root_path else ()


def _paths(uris: Iterable[str]) -> tuple[Path, ...]:
    return tuple(dict.fromkeys(path_of(uri) for uri in uris if uri.startswith("file:")))


async def _register(server: KinlintServer) -> None:
    """Ask to be told of changes of files, if the client can do that."""
    known = server.client_capabilities.workspace
    watching = known.did_change_watched_files if known else None
    if not watching or not watching.dynamic_registration:
        return
    watchers = [types.FileSystemWatcher(glob_pattern=pattern) for pattern in WATCHED]
    options = types.DidChangeWatchedFilesRegistrationOptions(watchers=watchers)
    method = types.WORKSPACE_DID_CHANGE_WATCHED_FILES
    registration = types.Registration(id="kinlint-files", method=method, register_options=options)
    try:
        await server.client_register_capability_async(types.RegistrationParams([registration]))
    except Exception as error:  # noqa: BLE001  whatever the client answers, there is work to do
        server.log(f"kinlint does not see changes on disk: {error}", types.MessageType.Warning)


def _can_be_asked(server: KinlintServer) -> bool:
    known = server.client_capabilities.workspace
    return bool(known and known.configuration)


async def _ask(server: KinlintServer) -> None:
    """Ask for the settings, if the client can tell them; nothing leaves what it said at first."""
    if not _can_be_asked(server):
        return
    item = types.ConfigurationItem(section=SECTION)
    try:
        said = await server.workspace_configuration_async(types.ConfigurationParams([item]))
    except Exception as error:  # noqa: BLE001  whatever the client answers, there is work to do
        server.log(f"kinlint does not receive its settings: {error}", types.MessageType.Warning)
        return
    if said and said[0] is not None:
        server.use_settings(ClientSettings.from_json(said[0]))


async def _outlive_nobody(process: int) -> None:
    """End when the client, which is *process*, ends."""
    while os.name != "nt":  # there, the end of standard input has to do
        await asyncio.sleep(PULSE)
        try:
            os.kill(process, 0)
        except ProcessLookupError:
            os._exit(1)
        except OSError:
            pass

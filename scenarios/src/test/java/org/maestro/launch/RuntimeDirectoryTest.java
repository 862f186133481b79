package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RuntimeDirectoryTest {
  @TempDir Path parent;

  @Test
  void isForItsUserAlone() throws Exception {
    Path path = parent.resolve("run");
    RuntimeDirectory directory = RuntimeDirectory.at(path);
    directory.add(
        new RuntimeDirectory.Running(
            "home",
            ProcessHandle.current().pid(),
            "127.0.0.1",
            1099,
            Optional.of("tcp://127.0.0.1:1883"),
            Optional.empty()));

    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(path)))
        .isEqualTo("rwx------");
    assertThat(
            PosixFilePermissions.toString(
                Files.getPosixFilePermissions(path.resolve("home.platform.json"))))
        .isEqualTo("rw-------");
  }

  @Test
  void knowsThePlatformsThatLive() {
    RuntimeDirectory directory = RuntimeDirectory.at(parent.resolve("run"));
    RuntimeDirectory.Running living =
        new RuntimeDirectory.Running(
            "here",
            ProcessHandle.current().pid(),
            "127.0.0.1",
            1099,
            Optional.empty(),
            Optional.empty());
    directory.add(living);
    directory.add(
        new RuntimeDirectory.Running(
            "gone", Long.MAX_VALUE, "127.0.0.1", 1100, Optional.empty(), Optional.empty()));

    assertThat(directory.running()).containsExactly(living);
    directory.remove("here");
    assertThat(directory.running()).isEmpty();
  }

  @Test
  void remembersWhoseStoriesAreTheLast() {
    RuntimeDirectory directory = RuntimeDirectory.at(parent.resolve("run"));

    assertThat(directory.lastStories()).isEmpty();
    Path first = directory.beginStories("first");
    Path second = directory.beginStories("second");
    assertThat(directory.lastStories()).contains(second).isNotEqualTo(Optional.of(first));
  }
}

package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BrokenBarrierException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.stream.IntStream;
import java.util.stream.Stream;
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
            Optional.empty(),
            Optional.empty()));

    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(path)))
        .isEqualTo("rwx------");
    assertThat(
            PosixFilePermissions.toString(
                Files.getPosixFilePermissions(path.resolve("home.platform.json"))))
        .isEqualTo("rw-------");
  }

  @Test
  void manyCommandsMayBeginAtTheSameMoment() throws Exception {
    int commands = 8;
    for (int round = 0; round < 20; round++) {
      Path path = parent.resolve("run" + round);
      CyclicBarrier together = new CyclicBarrier(commands);
      List<CompletableFuture<Path>> begun =
          IntStream.range(0, commands)
              .mapToObj(
                  i ->
                      CompletableFuture.supplyAsync(
                          () -> {
                            await(together);
                            return RuntimeDirectory.at(path).beginStories("home");
                          },
                          task -> new Thread(task).start()))
              .toList();
      for (CompletableFuture<Path> one : begun) {
        assertThat(one.get(30, TimeUnit.SECONDS)).isEqualTo(path.resolve("stories/home"));
      }
      assertThat(RuntimeDirectory.at(path).lastStories()).contains(path.resolve("stories/home"));
      try (Stream<Path> left = Files.list(path)) {
        assertThat(left).containsExactly(path.resolve("last-story"));
      }
    }
  }

  private static void await(CyclicBarrier barrier) {
    try {
      barrier.await(30, TimeUnit.SECONDS);
    } catch (InterruptedException | BrokenBarrierException | TimeoutException e) {
      throw new IllegalStateException(e);
    }
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
            Optional.empty(),
            Optional.of(URI.create("http://127.0.0.1:7070")));
    directory.add(living);
    directory.add(
        new RuntimeDirectory.Running(
            "gone",
            Long.MAX_VALUE,
            "127.0.0.1",
            1100,
            Optional.empty(),
            Optional.empty(),
            Optional.empty()));

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

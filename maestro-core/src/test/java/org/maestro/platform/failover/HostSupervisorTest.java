package org.maestro.platform.failover;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.platform.hosts.HostStart;

/** Processes of hosts are started, and started again when they have died (ADE, 3.2; A36). */
class HostSupervisorTest {
  private static final Duration LIMIT = Duration.ofSeconds(20);

  @TempDir Path directory;

  @Test
  void whoDiesAgainAndAgainIsStartedMoreAndMoreSeldom() throws Exception {
    long began = System.nanoTime();
    try (HostSupervisor starter =
        starter("echo {name} {main} >> starts; exit 1", new AtomicBoolean())) {
      starter.begin(Duration.ZERO);
      await().atMost(LIMIT).until(() -> starts().size() >= 4);
    }
    // At once, at once again, then after 1 s and after 2 s more.
    assertThat(Duration.ofNanos(System.nanoTime() - began)).isGreaterThan(Duration.ofSeconds(3));
    assertThat(starts()).containsOnly("attic 127.0.0.1:1099").hasSize(4);
  }

  @Test
  void whoIsThereIsNotStartedAndAFrozenOneIsEndedFirst() throws Exception {
    AtomicBoolean isThere = new AtomicBoolean();
    try (HostSupervisor starter = starter("echo $$ >> starts; exec sleep 60", isThere)) {
      starter.begin(Duration.ZERO);
      await().atMost(LIMIT).until(() -> starts().size() == 1);
      ProcessHandle first = ProcessHandle.of(Long.parseLong(starts().get(0))).orElseThrow();

      starter.gone("attic");
      await().atMost(LIMIT).until(() -> starts().size() == 2);
      assertThat(first.isAlive()).isFalse();

      isThere.set(true);
      starter.gone("attic");
      ProcessHandle.of(Long.parseLong(starts().get(1))).ifPresent(left -> left.onExit().join());
      starter.gone("somebody-else");
      assertThat(starts()).hasSize(2);
    }
  }

  private HostSupervisor starter(String script, AtomicBoolean isThere) {
    List<String> command = List.of("sh", "-c", "cd " + directory + "; " + script);
    return new HostSupervisor(
        List.of(new HostStart("attic", Set.of(), Set.of(), command)),
        "127.0.0.1:1099",
        directory,
        name -> isThere.get());
  }

  private List<String> starts() {
    Path file = directory.resolve("starts");
    try {
      return Files.exists(file) ? Files.readAllLines(file) : List.of();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}

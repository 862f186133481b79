package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A platform on a real disk that is full for a while, as its users see it. */
@Tag("full")
class FullDiskTest {
  private static final Duration LIMIT = Duration.ofSeconds(120);
  private static final int MOST_GOALS = 20;

  @TempDir private Path directory;
  private Path disk;

  @BeforeEach
  void mount() throws Exception {
    disk = Files.createDirectories(directory.resolve("disk"));
    assumeTrue(
        ran("mount", "-t", "tmpfs", "-o", "size=512k", "tmpfs", disk.toString()),
        "no file system can be mounted here; root can");
  }

  @AfterEach
  void unmount() throws Exception {
    ran("umount", "-l", disk.toString());
  }

  private static boolean ran(String... command) throws Exception {
    try {
      Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
      process.getOutputStream().close();
      process.getInputStream().readAllBytes();
      return process.waitFor(20, TimeUnit.SECONDS) && process.exitValue() == 0;
    } catch (IOException e) {
      return false;
    }
  }

  private JavaProcess maestro(String... arguments) throws IOException {
    Path runtime = Files.createDirectories(directory.resolve("runtime"));
    return JavaProcess.startLogging(
        "org.maestro.launch.Maestro",
        List.of(arguments),
        Map.of("XDG_RUNTIME_DIR", runtime.toString()));
  }

  private JavaProcess run() throws IOException {
    return maestro(
        "run", "bob", "--port", "0", "--speed", "20", "--data", disk.resolve("data").toString());
  }

  private JavaProcess.Ended goal(String goal) throws Exception {
    try (JavaProcess asked = maestro("goal", goal)) {
      return asked.await(LIMIT);
    }
  }

  private static void runs(JavaProcess platform) {
    Awaitility.await()
        .atMost(LIMIT)
        .until(() -> platform.output().contains("The platform maestro runs"));
  }

  /** Takes all the room there is. */
  private Path fill() throws IOException {
    Path filling = disk.resolve("filling");
    try (OutputStream out = Files.newOutputStream(filling)) {
      byte[] block = new byte[512];
      while (true) {
        out.write(block);
      }
    } catch (IOException full) {
      return filling;
    }
  }

  /** What is left in the last page of the journal may do for some goals more. */
  private JavaProcess firstThatFindsNoRoom(JavaProcess platform) throws Exception {
    for (int goals = 0; goals < MOST_GOALS; goals++) {
      JavaProcess asked = maestro("goal", "(canSee ?agent Cup)");
      Awaitility.await().atMost(LIMIT).until(() -> isFull(platform) || !asked.isAlive());
      if (isFull(platform)) {
        return asked;
      }
      asked.close();
    }
    throw new AssertionError("The disk takes everything: " + platform.errors());
  }

  private static boolean isFull(JavaProcess platform) {
    return platform.errors().contains("No space left on device. New goals are refused");
  }

  @Test
  void goalsAreRefusedWithASentenceAndTakenOnAgainWhenThereIsRoom() throws Exception {
    try (JavaProcess platform = run()) {
      runs(platform);
      assertThat(goal("(>= (illuminance zone-b) 75)").output()).contains("Reached");

      Path filling = fill();
      try (JavaProcess waiting = firstThatFindsNoRoom(platform)) {
        JavaProcess.Ended refused = goal("(canSee ?agent Bob)");
        assertThat(refused.errors())
            .contains("The goal is not taken on, because the journal in " + disk.resolve("data"))
            .contains("No space left on device")
            .doesNotContain("Exception");
        assertThat(refused.exitCode()).as("it is the disk, and not what was asked").isEqualTo(3);
        String sign = Files.readString(disk.resolve("data/duty-beat"));
        Awaitility.await("who stands by hears that it lives")
            .atMost(LIMIT)
            .until(
                () -> Files.readString(disk.resolve("data/duty-beat")),
                now -> !now.isEmpty() && !now.equals(sign));

        Files.delete(filling);
        Awaitility.await()
            .atMost(LIMIT)
            .until(() -> platform.errors().contains("can be written again"));
        JavaProcess.Ended ended = waiting.await(LIMIT);
        assertThat(ended.output() + ended.errors())
            .as("one that was taken on goes on")
            .containsAnyOf("Reached", "The goal is not taken on");
      }
      assertThat(goal("(canSee ?agent Bob)").output()).contains("Reached");
      assertThat(platform.errors()).doesNotContain("Exception");
      platform.kill();
    }
    try (JavaProcess platform = run()) {
      runs(platform);
      try (JavaProcess goals = maestro("goals")) {
        assertThat(goals.await(LIMIT).output())
            .contains("(canSee ?agent Bob)")
            .doesNotContain("submitted");
      }
    }
  }
}

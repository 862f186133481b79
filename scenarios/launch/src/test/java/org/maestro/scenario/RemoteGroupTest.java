package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.assembly.LocalSite;
import org.maestro.launch.JavaProcess;

/**
 * An agent that stands for a group keeps its goal while its members' agents live in another process
 * (Three-layered architecture, 3.3.1, 3.3.2 and 5.1; M64, M70, M91); itself it stays where the
 * collective knowledge is.
 */
@Isolated("its time is wall time, which others beside it would take")
class RemoteGroupTest {
  private static final double SPEED = 10;
  private static final List<String> LAMPS = List.of("lamp-b1", "lamp-b2", "lamp-b3");

  @Test
  void aGroupKeepsItsRoomLitWithLampsOfAnotherProcess(@TempDir Path directory) throws Exception {
    try (LocalSite site =
        LocalSite.paced(OwnAccordTest.site("remote-group", OwnAccordTest.KEEPER, "", ""), SPEED)) {
      until(() -> site.world().lux("zone-b") >= 72);
      try (JavaProcess refused = take(site, directory, "groups")) {
        JavaProcess.Ended ended = refused.await(Duration.ofSeconds(60));
        assertThat(ended.exitCode()).isNotZero();
        assertThat(ended.errors()).contains("groups stays where the collective knowledge is");
      }
      List<String> told = new CopyOnWriteArrayList<>();
      site.platform().onStory(entry -> told.add(entry.text()));
      try (JavaProcess lights = take(site, directory, "lights")) {
        until(() -> lights.output().contains("The container lights runs here"));
        until(() -> site.platform().presentMembers().containsAll(LAMPS));
        assertThat(site.platform().topics()).contains("groups").doesNotContain("lights");
        // What is awaited stays so: a moment of darkness may be over before anybody looks.
        site.world().setAmbient("zone-b", 200);
        until(() -> lampLevels(site) == 0);
        site.world().setAmbient("zone-b", 0);
        until(() -> site.world().lux("zone-b") >= 72);
        assertThat(told).noneMatch(text -> text.contains("was started again"));
      }
    }
  }

  private static double lampLevels(LocalSite site) {
    return LAMPS.stream().mapToDouble(site.world()::lampLevel).sum();
  }

  private static JavaProcess take(LocalSite site, Path directory, String topic) throws Exception {
    return JavaProcess.start(
        "org.maestro.launch.Maestro",
        List.of("container", "--main", "127.0.0.1:" + site.platform().port(), "--name", topic),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }

  private static void until(BooleanSupplier condition) {
    await().atMost(Duration.ofSeconds(40)).until(condition::getAsBoolean);
  }
}

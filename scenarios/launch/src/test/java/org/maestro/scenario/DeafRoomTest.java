package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Objects;
import java.util.UUID;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;
import org.slf4j.LoggerFactory;

/** The recogniser of a room needs a host with a microphone, and there is none (A38). */
@ResourceLock("the log of rooms")
class DeafRoomTest {
  private static final String DEAF =
      "There is a problem with my speech recognition, so you will need to use the keyboard"
          + " interface.";
  private static final String WHY =
      "There is a problem with microphone: its agent needs microphone, which no host that is there"
          + " provides";
  private static final String MICROPHONE = "home:microphone a :Microphone ;";

  private static String text(String name) {
    try (InputStream resource =
        Objects.requireNonNull(LocalSite.class.getResourceAsStream(name), name)) {
      return new String(resource.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static Stage stage() {
    String parlour =
        text("/homes/parlour.ttl")
            .replace(MICROPHONE, MICROPHONE + " maestro:hostNeeds \"microphone\" ;");
    Home home = new HomeLoader().load(parlour, "parlour.ttl");
    byte[] scene = text("/scenes/parlour.ttl").getBytes(StandardCharsets.UTF_8);
    return Stage.stepped(
        SiteSettings.of("deaf-" + UUID.randomUUID(), home)
            .scene(SceneLoader.load("parlour", new ByteArrayInputStream(scene), home))
            .build());
  }

  @Test
  void theRoomSaysThatItHearsNothingAndTheLogWhy() {
    Logger ours = (Logger) LoggerFactory.getLogger("org.maestro");
    ListAppender<ILoggingEvent> log = new ListAppender<>();
    log.start();
    ours.addAppender(log);
    try (Stage stage = stage()) {
      stage.await(
          "it is spoken",
          () ->
              stage.world().talk().sounded().stream()
                  .anyMatch(sounded -> sounded.text().equals(DEAF)));
      assertThat(new ArrayList<>(log.list))
          .extracting(ILoggingEvent::getFormattedMessage)
          .anyMatch(line -> line.contains(WHY))
          .anyMatch(line -> line.contains("without microphone") && line.endsWith(DEAF));
      stage.speaker("Dave").in("parlour").says("turn on the light").isReached();
    } finally {
      ours.detachAppender(log);
    }
  }
}

package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.assembly.SiteSettings;
import org.maestro.dialogue.Dialogues;
import org.maestro.junit.Speaker;
import org.maestro.junit.Stage;
import org.maestro.language.Language;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.time.Clock;
import org.maestro.sim.SimulatedHome;
import org.maestro.sim.scene.SceneLoader;

/**
 * What is in a home and which language is spoken there is said by files: with others in their place
 * the same program, started anew, is another house with other words (ADE, 6; A95).
 */
class OtherLanguageByFileTest {
  private static final AtomicInteger STARTS = new AtomicInteger();

  /** One class of each part of the program. */
  private static final List<Class<?>> PARTS =
      List.of(
          Language.class,
          Dialogues.class,
          HomeLoader.class,
          Clock.class,
          SimulatedHome.class,
          SiteSettings.class);

  @TempDir Path folder;

  @Test
  void otherFilesMakeAnotherHouseOfTheSameProgram() throws IOException {
    String program = hash();
    place(
        text("/homes/bob.ttl")
            + brings("fr")
            + "home:lamp-a1 maestro:alsoCalled \"la petite lampe\"@fr .\n",
        "fr");
    try (Stage stage = started()) {
      Speaker bob = stage.speaker("Bob").in("room-a");
      bob.says("Allume la petite lampe, s'il te plaît")
          .means("(initCNP (:goal (= (level lamp-a1) 1)))")
          .isReached();
      bob.says("La lampe A1 est-elle allumée ?").replies("Oui.");
      bob.says("Peux-tu éteindre la lumière ?")
          .means("(initCNP (:goal (= (level lamp-a1) 0)))")
          .isReached();
    }

    place(
        text("/homes/bob.ttl").replace("lamp-a1", "tischlampe").replace("Lampe A1", "Tischlampe")
            + brings("de-AT"),
        "de-AT");
    try (Stage stage = started()) {
      Speaker bob = stage.speaker("Bob").in("room-a");
      bob.says("Geh, dreh bitte die Tischlampe auf")
          .means("(initCNP (:goal (= (level tischlampe) 1)))")
          .isReached();
      bob.says("Ist die Tischlampe an?").replies("Ja.");
      bob.says("Servas").replies("Servas.");
      bob.says("Allume la petite lampe").isRefused("Ich kenne das Wort „allume la petite“ nicht.");
    }

    assertThat(hash()).isEqualTo(program);
  }

  private static String brings(String tag) {
    return """

        <https://w3id.org/maestro/home/bob> maestro:language "%s" ;
          maestro:grammarFile "%s.grammar" ; maestro:wordsFile "%s.ttl" .
        """
        .formatted(tag, tag, tag);
  }

  /** Other files take the place of all that were there. */
  private void place(String home, String language) throws IOException {
    try (Stream<Path> former = Files.list(folder)) {
      for (Path file : former.toList()) {
        Files.delete(file);
      }
    }
    Files.writeString(folder.resolve("home.ttl"), home);
    for (String ending : List.of(".grammar", ".ttl")) {
      Files.writeString(
          folder.resolve(language + ending),
          text("/org/maestro/scenario/languages/" + language + ending));
    }
  }

  private Stage started() {
    Home home = new HomeLoader().load(folder.resolve("home.ttl"));
    String scene = text("/scenes/bob-dark.ttl").replace("lamp-a1", firstLamp(home));
    return Stage.stepped(
        SiteSettings.of("language-" + STARTS.incrementAndGet(), home)
            .scene(
                SceneLoader.load(
                    "bob-dark",
                    new ByteArrayInputStream(scene.getBytes(StandardCharsets.UTF_8)),
                    home))
            .build());
  }

  private static String firstLamp(Home home) {
    return home.devices().containsKey("lamp-a1") ? "lamp-a1" : "tischlampe";
  }

  private static String text(String resource) {
    try (InputStream stream =
        Objects.requireNonNull(
            OtherLanguageByFileTest.class.getResourceAsStream(resource), resource)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Of all files of the program, classes and what is shipped with them. */
  private static String hash() throws IOException {
    try {
      MessageDigest digest = MessageDigest.getInstance("SHA-256");
      for (Class<?> part : PARTS) {
        Path place = Path.of(part.getProtectionDomain().getCodeSource().getLocation().toURI());
        try (Stream<Path> files = Files.walk(place)) {
          for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
            digest.update(place.relativize(file).toString().getBytes(StandardCharsets.UTF_8));
            digest.update(Files.readAllBytes(file));
          }
        }
      }
      return HexFormat.of().formatHex(digest.digest());
    } catch (NoSuchAlgorithmException | URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }
}

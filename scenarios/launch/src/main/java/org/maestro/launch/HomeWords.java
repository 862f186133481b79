package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import org.maestro.console.documents.WordsDocument;
import org.maestro.console.questions.Questions;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.WordList;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** The words of a home that a command names, or else of the running platform. */
final class HomeWords {
  @Mixin private PlatformOptions platform;

  @Parameters(
      arity = "0..1",
      paramLabel = "HOME.ttl",
      completionCandidates = Shipped.Homes.class,
      description = "A home file, or a shipped home: bob, arena; without: the running platform.")
  private Optional<String> home = Optional.empty();

  JsonNode document() {
    return home.map(Shipped::home)
        .map(WordList::of)
        .map(WordsDocument::of)
        .orElseGet(this::ofThePlatform);
  }

  /** The home that is named. */
  Home home() {
    return Shipped.home(
        home.orElseThrow(
            () -> CommandException.badInput("--language goes with a home, such as evening.")));
  }

  private JsonNode ofThePlatform() {
    try (AskedPlatform asked = platform.ask()) {
      return asked.answer(Questions::words);
    }
  }
}

package org.maestro.launch;

import java.net.URI;
import java.time.Duration;
import java.util.Optional;
import org.maestro.console.opinion.ChatCompletions;
import org.maestro.dialogue.Paraphraser;
import picocli.CommandLine.Option;

/** The options that say which language model is asked for a second opinion. */
final class OpinionOptions {
  private static final String KEY = "MAESTRO_SECOND_OPINION_KEY";

  @Option(
      names = "--second-opinion",
      paramLabel = "URL",
      description =
          "Ask a language model what was meant by words that are not understood: the base of an"
              + " OpenAI-compatible server, such as http://127.0.0.1:8080/v1. It is told the words"
              + " and what things here are called, and proposes a sentence; whether that is meant is"
              + " asked back before anything is done. Its key is read from "
              + KEY
              + ".")
  private Optional<URI> server = Optional.empty();

  @Option(
      names = "--second-opinion-model",
      paramLabel = "NAME",
      description = "The model, where the server has several.")
  private Optional<String> model = Optional.empty();

  /** Whether it can be asked. */
  void check() {
    server.ifPresent(OpinionOptions::check);
  }

  private static void check(URI server) {
    boolean isHttp = "http".equals(server.getScheme()) || "https".equals(server.getScheme());
    if (!isHttp || server.getHost() == null) {
      throw CommandException.badInput(
          "--second-opinion takes the address of a server, such as http://127.0.0.1:8080/v1; not \"%s\"."
              .formatted(server));
    }
  }

  /** Where it is; empty when nobody is to be asked. */
  Optional<URI> server() {
    return server;
  }

  /**
   * The one who is asked.
   *
   * @param patience wall time that an answer may take
   */
  Optional<Paraphraser> paraphraser(Duration patience) {
    return server.map(
        base ->
            new ChatCompletions(base, model, Optional.ofNullable(System.getenv(KEY)), patience));
  }
}

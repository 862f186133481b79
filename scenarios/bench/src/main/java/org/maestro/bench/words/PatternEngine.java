package org.maestro.bench.words;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The engine hassil, which matches whole sentences with templates, in a process of python3. Used
 * only where it is installed.
 */
final class PatternEngine {
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final double MILLIS = 1e3;

  private PatternEngine() {}

  /**
   * What it found.
   *
   * @param matched how many of the sentences
   * @param millis of each sentence and time
   */
  record Found(int matched, List<Double> millis) {
    Found {
      millis = List.copyOf(millis);
    }
  }

  /**
   * Matches sentences with the templates that come with this benchmark.
   *
   * @param times how often each is measured, after once to warm up
   * @return empty when it, or python3, is not installed
   */
  static Optional<Found> match(List<String> sentences, ManyNames names, int times) {
    ObjectNode given = JSON.createObjectNode();
    try {
      given.set("templates", JSON.readTree(WordFiles.text("templates.json")));
    } catch (JsonProcessingException e) {
      throw new UncheckedIOException("The templates are no JSON.", e);
    }
    names.things().forEach(given.putArray("names")::add);
    names.titles().forEach(given.putArray("titles")::add);
    titlesThatAreSaid().forEach(given.withArray("titles")::add);
    sentences.forEach(given.putArray("sentences")::add);
    given.put("times", times);
    return run(given)
        .filter(answer -> !answer.path("missing").asBoolean())
        .map(PatternEngine::found);
  }

  private static List<String> titlesThatAreSaid() {
    return WordFiles.lines("whole.txt").stream()
        .filter(line -> line.startsWith("play ") && !line.startsWith("play the "))
        .map(line -> line.substring("play ".length()))
        .toList();
  }

  private static Found found(JsonNode answer) {
    int matched = 0;
    for (JsonNode intent : answer.path("matched")) {
      matched += intent.isNull() ? 0 : 1;
    }
    List<Double> millis = new ArrayList<>();
    answer.path("seconds").forEach(seconds -> millis.add(seconds.asDouble() * MILLIS));
    return new Found(matched, millis);
  }

  private static Optional<JsonNode> run(ObjectNode given) {
    try {
      Process process =
          new ProcessBuilder("python3", "-c", WordFiles.text("matching.py"))
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      try (OutputStream to = process.getOutputStream()) {
        to.write(JSON.writeValueAsBytes(given));
      } catch (IOException e) {
        // It ended without reading: then hassil is missing, which its answer tells.
      }
      try (InputStream from = process.getInputStream()) {
        String answer = new String(from.readAllBytes(), StandardCharsets.UTF_8);
        return answer.isBlank() ? Optional.empty() : Optional.of(JSON.readTree(answer));
      } finally {
        process.destroy();
      }
    } catch (IOException e) {
      return Optional.empty();
    }
  }
}

package org.maestro.platform;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.maestro.coordination.Story;
import org.maestro.coordination.StoryEntry;

/**
 * Keeps each goal's story as a file of JSON lines, so that it can be read when the platform is
 * gone.
 */
public final class StoryFile implements Story {
  private static final String ENDING = ".jsonl";

  private final Path directory;
  private final ObjectMapper json = new ObjectMapper();

  public StoryFile(Path directory) {
    this.directory = directory;
  }

  /** Removes the stories of the platform before. */
  public void begin() {
    try {
      Files.createDirectories(directory);
      for (String goalId : goals()) {
        Files.delete(directory.resolve(goalId + ENDING));
      }
    } catch (IOException e) {
      throw new PlatformStartException("Stories cannot be kept in " + directory + ".", e);
    }
  }

  @Override
  public void tell(StoryEntry entry) {
    ObjectNode line = json.createObjectNode();
    line.put("goal", entry.goalId());
    line.put("at_s", entry.at().toMillis() / 1000.0);
    line.put("kind", entry.kind().name());
    line.put("text", entry.text());
    try {
      Files.writeString(
          directory.resolve(entry.goalId() + ENDING),
          line + "\n",
          StandardCharsets.UTF_8,
          StandardOpenOption.CREATE,
          StandardOpenOption.APPEND);
    } catch (IOException e) {
      throw new UncheckedIOException("The story of " + entry.goalId() + " cannot be kept", e);
    }
  }

  /** Ids of the goals with a story. */
  public List<String> goals() {
    if (!Files.isDirectory(directory)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(directory)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.endsWith(ENDING))
          .map(name -> name.substring(0, name.length() - ENDING.length()))
          .sorted()
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException("Stories in " + directory + " cannot be read", e);
    }
  }

  /** A goal's story; empty when there is none. */
  public List<StoryEntry> read(String goalId) {
    if (!goals().contains(goalId)) {
      return List.of();
    }
    List<StoryEntry> entries = new ArrayList<>();
    try {
      for (String line : Files.readAllLines(directory.resolve(goalId + ENDING))) {
        entries.add(entry(json.readTree(line)));
      }
    } catch (JsonProcessingException e) {
      throw new UncheckedIOException("The story of " + goalId + " is damaged", e);
    } catch (IOException e) {
      throw new UncheckedIOException("The story of " + goalId + " cannot be read", e);
    }
    return entries;
  }

  private static StoryEntry entry(JsonNode line) {
    return new StoryEntry(
        line.path("goal").asText(),
        Duration.ofMillis(Math.round(line.path("at_s").asDouble() * 1000)),
        StoryEntry.Kind.valueOf(line.path("kind").asText()),
        line.path("text").asText());
  }
}

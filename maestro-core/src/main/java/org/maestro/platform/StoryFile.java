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
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.maestro.coordination.Story;
import org.maestro.coordination.StoryEntry;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps each goal's story as a file of JSON lines, so that it can be read when the platform is
 * gone.
 */
public final class StoryFile implements Story {
  private static final Logger LOG = LoggerFactory.getLogger(StoryFile.class);
  private static final String ENDING = ".jsonl";

  private final Path directory;
  private final Optional<Timeline> timeline;
  private final ObjectMapper json = new ObjectMapper();

  private StoryFile(Path directory, Optional<Timeline> timeline) {
    this.directory = directory;
    this.timeline = timeline;
  }

  /** To be read only, in times of the clock that was used last. */
  public StoryFile(Path directory) {
    this(directory, Optional.empty());
  }

  /** To be written and read in times of the clock. */
  StoryFile(Path directory, Clock clock) {
    this(directory, Optional.of(Timeline.of(clock)));
  }

  /** Removes the stories of the platform before, except those that are wanted still. */
  void begin(Set<String> wanted) {
    try {
      Files.createDirectories(directory);
      for (String goalId : goals()) {
        if (!wanted.contains(goalId)) {
          Files.delete(directory.resolve(goalId + ENDING));
        }
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
    timeline.ifPresent(
        clock -> line.put("since", clock.since().toString()).put("speed", clock.speed()));
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
      List<String> lines = Files.readAllLines(directory.resolve(goalId + ENDING));
      List<JsonNode> nodes = new ArrayList<>();
      for (int n = 0; n < lines.size(); n++) {
        try {
          nodes.add(json.readTree(lines.get(n)));
        } catch (JsonProcessingException e) {
          if (n < lines.size() - 1) {
            throw e;
          }
          LOG.warn("The last line of the story of {} was not written to its end", goalId);
        }
      }
      for (JsonNode node : nodes) {
        entries.add(entry(node, timeline.orElse(timeline(nodes.get(nodes.size() - 1)))));
      }
    } catch (JsonProcessingException e) {
      throw new UncheckedIOException("The story of " + goalId + " is damaged", e);
    } catch (IOException e) {
      throw new UncheckedIOException("The story of " + goalId + " cannot be read", e);
    }
    return entries;
  }

  private static Timeline timeline(JsonNode line) {
    return new Timeline(
        Instant.parse(line.path("since").asText(Instant.EPOCH.toString())),
        line.path("speed").asDouble(1));
  }

  private static StoryEntry entry(JsonNode line, Timeline wanted) {
    Duration at = Duration.ofMillis(Math.round(line.path("at_s").asDouble() * 1000));
    return new StoryEntry(
        line.path("goal").asText(),
        timeline(line).translate(at, wanted),
        StoryEntry.Kind.valueOf(line.path("kind").asText()),
        line.path("text").asText());
  }
}

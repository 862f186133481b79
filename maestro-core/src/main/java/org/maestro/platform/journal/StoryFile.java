package org.maestro.platform.journal;

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
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.maestro.coordination.api.Story;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.rats.time.Clock;
import org.maestro.storage.WritingAside;
import org.maestro.text.VisibleText;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps each goal's story as a file of JSON lines, so that it can be read when the platform is
 * gone. Told on any one thread at a time; written beside it.
 */
public final class StoryFile implements Story, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(StoryFile.class);
  private static final String ENDING = ".jsonl";
  private static final String SUBJECT = "Stories";

  private final Path directory;
  private final Optional<Timeline> timeline;
  private final ObjectMapper json = new ObjectMapper();

  private final WritingAside aside;

  /** Goals whose last line may have been cut short; the writing thread's. */
  private final Set<String> torn = new HashSet<>();

  private StoryFile(Path directory, Optional<Timeline> timeline, WritingAside aside) {
    this.directory = directory;
    this.timeline = timeline;
    this.aside = aside;
  }

  /** To be read only, in times of the clock that was used last. */
  public StoryFile(Path directory) {
    this(directory, Optional.empty(), WritingAside.atOnce(SUBJECT));
  }

  /** To be written and read in times of the clock; to be closed when all is told. */
  public static StoryFile open(Path directory, Clock clock) {
    return new StoryFile(
        directory,
        Optional.of(Timeline.of(clock)),
        clock.isStepped() ? WritingAside.atOnce(SUBJECT) : WritingAside.begin(SUBJECT));
  }

  /** Removes the stories of the platform before, except those that are wanted still. */
  public void begin(Set<String> wanted) {
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
    if (!entry.privateWords().isEmpty()) {
      new TreeSet<>(entry.privateWords()).forEach(line.putArray("private")::add);
    }
    byte[] text = (VisibleText.line(line.toString()) + "\n").getBytes(StandardCharsets.UTF_8);
    aside.add(text.length, () -> write(entry.goalId(), text));
  }

  /** A line that was cut short before is ended first. */
  private void write(String goalId, byte[] line) throws IOException {
    boolean afterPart = torn.contains(goalId);
    torn.add(goalId);
    Files.write(
        directory.resolve(goalId + ENDING),
        afterPart
            ? ("\n" + new String(line, StandardCharsets.UTF_8)).getBytes(StandardCharsets.UTF_8)
            : line,
        StandardOpenOption.CREATE,
        StandardOpenOption.APPEND);
    torn.remove(goalId);
  }

  /** What was told is written, or left away when the disk does not take it in time. */
  @Override
  public void close() {
    aside.close();
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
          if (!lines.get(n).isBlank()) {
            nodes.add(json.readTree(lines.get(n)));
          }
        } catch (JsonProcessingException e) {
          LOG.warn(
              "Line {} of the story of {} is damaged and left out: {}",
              n + 1,
              goalId,
              e.getOriginalMessage());
        }
      }
      for (JsonNode node : nodes) {
        entries.add(entry(node, timeline.orElse(timeline(nodes.get(nodes.size() - 1)))));
      }
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
    Set<String> words = new TreeSet<>();
    line.path("private").forEach(word -> words.add(word.asText()));
    return new StoryEntry(
        line.path("goal").asText(),
        timeline(line).translate(at, wanted),
        StoryEntry.Kind.valueOf(line.path("kind").asText()),
        line.path("text").asText(),
        words);
  }
}

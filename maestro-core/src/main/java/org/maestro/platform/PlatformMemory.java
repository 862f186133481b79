package org.maestro.platform;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.agents.goals.Past;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.diary.Diary;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.platform.journal.AnswerFile;
import org.maestro.platform.journal.JournalFile;
import org.maestro.platform.journal.StoryFile;
import org.maestro.rats.time.Clock;

/** The files that a platform keeps on disk, and what it found there. */
final class PlatformMemory implements AutoCloseable {
  private final Optional<JournalFile> journal;
  private final Optional<StoryFile> stories;
  private final AnswerFile answers;
  private final Diary diary;

  private PlatformMemory(
      Optional<JournalFile> journal, Optional<StoryFile> stories, AnswerFile answers, Diary diary) {
    this.journal = journal;
    this.stories = stories;
    this.answers = answers;
    this.diary = diary;
  }

  /**
   * @throws PlatformStartException when a directory of the settings cannot be used
   */
  static PlatformMemory open(PlatformSettings settings, KnowledgeBase knowledge, Clock clock) {
    Optional<JournalFile> journal =
        settings
            .dataDirectory()
            .map(
                directory ->
                    JournalFile.open(
                        directory, clock, name -> knowledge.home().vocabulary().isFluent(name)));
    Optional<StoryFile> stories =
        settings.storyDirectory().map(directory -> StoryFile.open(directory, clock));
    Diary diary =
        new Diary(
            knowledge::home,
            clock,
            settings.dataDirectory().map(directory -> directory.resolve("diary")));
    PlatformMemory memory = new PlatformMemory(journal, stories, AnswerFile.inMemory(), diary);
    try {
      stories.ifPresent(files -> files.begin(memory.goals()));
      return settings
          .dataDirectory()
          .map(
              directory ->
                  new PlatformMemory(journal, stories, AnswerFile.open(directory, clock), diary))
          .orElse(memory);
    } catch (PlatformStartException e) {
      memory.close();
      throw e;
    }
  }

  private Recovery recovery() {
    return journal.map(JournalFile::recovery).orElse(Recovery.NOTHING);
  }

  private Set<String> goals() {
    Set<String> goals = new TreeSet<>();
    recovery().goals().forEach(goal -> goals.add(goal.id()));
    recovery().ended().forEach(goal -> goals.add(goal.outcome().id()));
    return goals;
  }

  /** Why what has to be written down first is not done now. */
  Optional<String> impediment() {
    return journal.flatMap(JournalFile::impediment);
  }

  Optional<StoryFile> stories() {
    return stories;
  }

  /** Answers to questions of scripts. */
  AnswerFile answers() {
    return answers;
  }

  /** What became so and was asked for, day by day. */
  Diary diary() {
    return diary;
  }

  Past past() {
    if (journal.isEmpty()) {
      return Past.none();
    }
    Map<String, List<StoryEntry>> told = new TreeMap<>();
    stories.ifPresent(
        files ->
            goals()
                .forEach(
                    goal -> {
                      List<StoryEntry> story = files.read(goal);
                      if (!story.isEmpty()) {
                        told.put(goal, story);
                      }
                    }));
    return new Past(journal.get(), recovery(), told);
  }

  @Override
  public void close() {
    journal.ifPresent(JournalFile::close);
    stories.ifPresent(StoryFile::close);
    answers.close();
    diary.close();
  }
}

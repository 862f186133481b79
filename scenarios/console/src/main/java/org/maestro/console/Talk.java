package org.maestro.console;

import java.time.InstantSource;
import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.stream.Stream;
import org.maestro.console.access.Readership;
import org.maestro.console.api.Operation;
import org.maestro.console.chat.Chat;
import org.maestro.console.chat.GoalStories;
import org.maestro.console.chat.HomeInterlocutor;
import org.maestro.console.chat.Moods;
import org.maestro.console.chat.Surroundings;
import org.maestro.console.questions.AclQuestions;
import org.maestro.dialogue.Paraphraser;
import org.maestro.platform.MaestroPlatform;

/** The dialogues with persons of the home, for who takes part in them. */
final class Talk implements AutoCloseable {
  private final MaestroPlatform platform;
  private final Readership readership;
  private final GoalStories stories = new GoalStories();
  private final Chat chat;
  private final Moods moods = new Moods();
  private final ScheduledExecutorService thread =
      Executors.newSingleThreadScheduledExecutor(
          task -> {
            Thread named = new Thread(task, "console-chat");
            named.setDaemon(true);
            return named;
          });
  private final Broadcast news;
  private List<Future<?>> rounds = List.of();

  Talk(
      MaestroPlatform platform,
      AclQuestions questions,
      Readership readership,
      Paraphraser paraphraser) {
    this.platform = platform;
    this.readership = readership;
    FacesOfTalk faces = new FacesOfTalk(platform.desk(), platform.knowledge());
    this.chat =
        new Chat(
            platform.knowledge()::home,
            HomeInterlocutor.of(
                new Surroundings(
                    platform.knowledge()::home,
                    platform.knowledge()::snapshot,
                    platform::instant,
                    platform::now,
                    platform::presentMembers,
                    readership,
                    faces::show),
                questions,
                stories,
                platform.dialogues()::with,
                paraphraser),
            questions::answer,
            questions::hear,
            platform.dialogues(),
            readership,
            InstantSource.system());
    this.news = new Broadcast("chat", chat, thread);
  }

  List<Operation> operations() {
    return Stream.concat(chat.operations().stream(), Stream.of(moods.operation())).toList();
  }

  EventSource news() {
    return news;
  }

  /** From now on it is told how goals fare, and what scripts say. */
  void begin() {
    platform.onStory(entry -> readership.toAll(entry).ifPresent(stories::tell));
    platform.desk().whenSaid(chat::hear);
    platform.desk().whenAnswered(chat::hear);
    platform
        .desk()
        .whenShown(
            (agent, mood) -> {
              moods.show(agent, mood);
              chat.see(agent, mood);
            });
    rounds = List.of(news.begin());
  }

  @Override
  public void close() {
    rounds.forEach(round -> round.cancel(false));
    thread.shutdownNow();
  }
}

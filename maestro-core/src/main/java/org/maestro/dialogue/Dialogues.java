package org.maestro.dialogue;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.coordination.api.Speech;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Facts;

/**
 * The dialogues of a home, one for each person: who goes on elsewhere, or by another way, goes on
 * where she was. Any thread may ask.
 */
public final class Dialogues {
  private final Supplier<Home> home;
  private final Supplier<? extends Facts> facts;
  private final Supplier<Instant> now;
  private final Map<String, SpokenWords> spokenByPerson = new TreeMap<>();
  private final AskedQuestions asked = new AskedQuestions();
  private final List<Consumer<Utterance>> listeners = new CopyOnWriteArrayList<>();

  /**
   * Nobody has said anything yet.
   *
   * @param home as it is known at the time
   * @param facts what is known at the time
   * @param now the time that clocks on the walls show
   */
  public Dialogues(Supplier<Home> home, Supplier<? extends Facts> facts, Supplier<Instant> now) {
    this.home = home;
    this.facts = facts;
    this.now = now;
  }

  /**
   * The one with her.
   *
   * @param person one of the home: for each other a conversation would be kept, too
   */
  public synchronized SpokenWords with(String person) {
    return spokenByPerson.computeIfAbsent(
        person,
        name ->
            new SpokenWords(
                home, facts, now, said -> listeners.forEach(listener -> listener.accept(said))));
  }

  /**
   * Is told of everything that is said to the end, on whichever thread it is read; not to be held
   * up.
   */
  public void listen(Consumer<Utterance> listener) {
    listeners.add(listener);
  }

  /**
   * What somebody says to a question of a script, as scripts take answers; the same words where
   * they are none in her language.
   */
  public String answer(Utterance utterance, Speech question) {
    return question
        .wanted()
        .map(Speech.Wanted::type)
        .flatMap(type -> with(utterance.person()).answer(utterance, type))
        .orElse(utterance.text());
  }

  /** The questions that scripts have asked. */
  public AskedQuestions asked() {
    return asked;
  }
}

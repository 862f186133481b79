package org.maestro.dialogue;

import java.util.Map;
import java.util.Optional;
import org.maestro.coordination.api.Speech;
import org.maestro.rats.bounded.BoundedMap;

/** The latest question of a script to each person, and in each room. Any thread may use it. */
public final class AskedQuestions {
  private static final int MOST = 500;

  private final Map<String, Speech> latest = BoundedMap.ofNewest(MOST);

  /** Something is said to people; what wants no answer is no question. */
  public synchronized void hear(Speech speech) {
    if (speech.wanted().isPresent()) {
      latest.put(speech.to(), speech);
    }
  }

  /** The one that what she says may answer; what is written as a goal or a question is one. */
  public synchronized Optional<Speech> answeredBy(Utterance utterance) {
    String text = utterance.text().strip();
    return text.startsWith("(") || text.startsWith("?") ? Optional.empty() : to(utterance);
  }

  private Optional<Speech> to(Utterance utterance) {
    return Optional.ofNullable(latest.get(utterance.person()))
        .or(() -> Optional.ofNullable(latest.get(utterance.room())));
  }

  /**
   * It was answered, by whatever way.
   *
   * @param part of the script that asked
   */
  public synchronized void answered(String part) {
    latest.values().removeIf(question -> question.part().equals(part));
  }

  /** It was answered, or nobody waits for an answer any more. */
  public synchronized void over(Speech question) {
    latest.remove(question.to(), question);
  }
}

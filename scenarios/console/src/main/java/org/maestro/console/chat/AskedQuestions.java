package org.maestro.console.chat;

import java.util.Map;
import java.util.Optional;
import org.maestro.coordination.api.Speech;
import org.maestro.rats.bounded.BoundedMap;

/** The latest question of a script to each person, and in each room. Any thread may use it. */
final class AskedQuestions {
  private static final int MOST = 500;

  private final Map<String, Speech> latest = BoundedMap.ofNewest(MOST);

  synchronized void asked(Speech question) {
    latest.put(question.to(), question);
  }

  /** The one that what she says may answer. */
  synchronized Optional<Speech> of(Utterance utterance) {
    return Optional.ofNullable(latest.get(utterance.person()))
        .or(() -> Optional.ofNullable(latest.get(utterance.room())));
  }

  synchronized void over(Speech question) {
    latest.remove(question.to(), question);
  }
}

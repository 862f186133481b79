package org.maestro.sim.drivers;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.maestro.hal.Ear;
import org.maestro.hal.Hypothesis;
import org.maestro.sim.parameters.SpeechData;
import org.maestro.sim.world.Talk;

/**
 * A microphone and recogniser that hears who speaks in its zone, and knows whose voice it is, which
 * is assumed: word by word, some of them heard otherwise at first, a few for good.
 */
final class SimulatedEar implements Ear, Talk.Listener {
  private static final String VOWELS = "aeiou";

  private final Actuator actuator;
  private final SpeechData data;
  private final String zone;
  private final List<Listener> listeners = new CopyOnWriteArrayList<>();
  private int sentences;

  private SimulatedEar(Actuator actuator, SpeechData data, String zone) {
    this.actuator = actuator;
    this.data = data;
    this.zone = zone;
  }

  /** It hears from now on. */
  static SimulatedEar start(Actuator actuator, SpeechData data, String zone) {
    SimulatedEar ear = new SimulatedEar(actuator, data, zone);
    actuator.world().talk().listen(ear);
    return ear;
  }

  @Override
  public Runnable listen(Listener listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }

  @Override
  public void begins(String person, Optional<String> where, List<String> words) {
    if (where.filter(zone::equals).isPresent()) {
      sentences++;
      new Sentence(sentences, person, words).next();
    }
  }

  private void tell(Hypothesis hypothesis) {
    Optional<String> defect = actuator.world().faults().defect(actuator.device());
    for (Listener listener : listeners) {
      if (defect.isPresent()) {
        listener.failed(defect.get());
      } else {
        listener.heard(hypothesis);
      }
    }
  }

  /** One of them; its words are heard one after the other. */
  private final class Sentence {
    private final int number;
    private final String person;
    private final List<String> said;
    private final List<String> heard = new ArrayList<>();

    Sentence(int number, String person, List<String> said) {
      this.number = number;
      this.person = person;
      this.said = said;
    }

    void next() {
      actuator.after(data.wordSeconds(), this::hear);
    }

    private void hear() {
      String word = said.get(heard.size());
      boolean isMisheard = actuator.happens(data.mishearShare());
      boolean isUnclear = actuator.happens(data.reviseShare());
      heard.add(isMisheard ? confused(word) : word);
      List<String> now = new ArrayList<>(heard);
      if (isUnclear) {
        now.set(now.size() - 1, confused(word));
      }
      tell(hypothesis(now, now.size() - 1, false));
      if (heard.size() < said.size()) {
        next();
      } else {
        actuator.after(data.silenceSeconds(), this::end);
      }
    }

    private void end() {
      Hypothesis whole = hypothesis(heard, heard.size(), true);
      tell(whole);
      actuator.after(data.repeatSeconds(), () -> tell(whole));
    }

    private Hypothesis hypothesis(List<String> words, int stable, boolean over) {
      return new Hypothesis(
          number,
          person,
          words,
          stable,
          data.confidence(),
          words.stream().map(word -> List.of(confused(word))).toList(),
          over);
    }
  }

  /** What sounds like it, by the next vowel in place of its last. */
  private static String confused(String word) {
    int last = VOWELS.chars().map(vowel -> word.lastIndexOf(vowel)).max().orElse(-1);
    if (last < 0) {
      return word;
    }
    int vowel = VOWELS.indexOf(word.charAt(last));
    char next = VOWELS.charAt((vowel + 1) % VOWELS.length());
    return word.substring(0, last) + next + word.substring(last + 1);
  }
}

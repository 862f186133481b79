package org.maestro.bench.words;

import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;

/**
 * Words for which a word may be taken by ear: those of many that are nearest by their sounds, then
 * by their letters. Sounds are told apart as coarsely as by a bad microphone. Not safe for threads.
 */
public final class SoundsAlike {
  private static final int NEAREST = 8;

  /** Letters of which one is easily taken for another, by groups. */
  private static final String[] GROUPS = {"bp", "fvw", "dt", "cgkqx", "sz", "jy", "mn", "l", "r"};

  private final List<Sounded> words;
  private final Map<String, List<String>> known = new HashMap<>();

  private record Sounded(String word, String sounds) {}

  /** Among these words. */
  public SoundsAlike(Collection<String> among) {
    this.words =
        new TreeSet<>(among).stream().map(word -> new Sounded(word, sounds(word))).toList();
  }

  /** The nearest words, which are others; the nearest first. */
  public List<String> to(String word) {
    return known.computeIfAbsent(word, this::nearest);
  }

  private List<String> nearest(String word) {
    String sounds = sounds(word);
    return words.stream()
        .filter(other -> !other.word().equals(word))
        .filter(other -> isOfFigures(other.word()) == isOfFigures(word))
        .sorted(
            Comparator.comparingInt(
                other -> 2 * distance(sounds, other.sounds()) + distance(word, other.word())))
        .limit(NEAREST)
        .map(Sounded::word)
        .toList();
  }

  private static boolean isOfFigures(String word) {
    return word.chars().allMatch(Character::isDigit);
  }

  /** Vowels are all alike, letters of a group too; what is doubled sounds once. */
  private static String sounds(String word) {
    StringBuilder sounds = new StringBuilder();
    for (int i = 0; i < word.length(); i++) {
      char sound = sound(word.charAt(i));
      if (sounds.isEmpty() || sounds.charAt(sounds.length() - 1) != sound) {
        sounds.append(sound);
      }
    }
    return sounds.toString();
  }

  private static char sound(char letter) {
    for (String group : GROUPS) {
      if (group.indexOf(letter) >= 0) {
        return group.charAt(0);
      }
    }
    return "aeiou".indexOf(letter) >= 0 ? 'a' : letter;
  }

  /** How many letters are to be changed, left out or put in. */
  private static int distance(String one, String other) {
    int[] before = new int[other.length() + 1];
    for (int j = 0; j < before.length; j++) {
      before[j] = j;
    }
    for (int i = 1; i <= one.length(); i++) {
      int[] now = new int[before.length];
      now[0] = i;
      for (int j = 1; j < now.length; j++) {
        int changed = before[j - 1] + (one.charAt(i - 1) == other.charAt(j - 1) ? 0 : 1);
        now[j] = Math.min(changed, 1 + Math.min(before[j], now[j - 1]));
      }
      before = now;
    }
    return before[other.length()];
  }
}

package org.maestro.bench.words;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Noise between who speaks and who hears: of the words some are lost, exchanged with the next, or
 * taken for others that sound alike. The same seed makes the same noise. Not safe for threads.
 */
public final class Noise {
  private final SoundsAlike alike;
  private final Random random;

  public Noise(SoundsAlike alike, long seed) {
    this.alike = alike;
    this.random = new Random(seed);
  }

  /**
   * What is heard of the words.
   *
   * @param share of how many words something happens to each, from 0 to 1; each of the three as
   *     often
   */
  public List<String> of(List<String> words, double share) {
    List<String> heard = new ArrayList<>();
    for (int i = 0; i < words.size(); i++) {
      String word = words.get(i);
      if (random.nextDouble() >= share) {
        heard.add(word);
        continue;
      }
      switch (random.nextInt(3)) {
        case 0 -> {} // Lost.
        case 1 -> {
          if (i + 1 < words.size()) {
            heard.add(words.get(i + 1));
            i++;
          }
          heard.add(word);
        }
        default -> heard.add(misheard(word));
      }
    }
    return heard;
  }

  private String misheard(String word) {
    List<String> others = alike.to(word);
    return others.isEmpty() ? word : others.get(random.nextInt(others.size()));
  }
}

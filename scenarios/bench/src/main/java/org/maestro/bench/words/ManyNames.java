package org.maestro.bench.words;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** A home with as many more things and titles as are wished, of invented names. Immutable. */
final class ManyNames {
  private static final String[] SYLLABLES = {
    "ba", "to", "ri", "lu", "ne", "ka", "mo", "si", "fa", "do", "wen", "gar", "pil", "tor"
  };
  private static final String[] KINDS = {"DrinkingCup", "Glass", "Plate"};
  private static final String[] ROOMS = {"kitchen", "livingroom", "bedroom"};
  private static final int LONGEST_TITLE = 4;
  private static final long SEED = 1;

  private final List<String> things;
  private final List<String> titles;

  ManyNames(int things, int titles) {
    Random random = new Random(SEED);
    this.things = distinct(things, () -> word(random));
    this.titles =
        distinct(
            titles,
            () -> {
              List<String> words = new ArrayList<>();
              int length = 1 + random.nextInt(LONGEST_TITLE);
              for (int i = 0; i < length; i++) {
                words.add(word(random));
              }
              return String.join(" ", words);
            });
  }

  private interface Drawn {
    String next();
  }

  private static List<String> distinct(int count, Drawn drawn) {
    Set<String> found = new LinkedHashSet<>();
    while (found.size() < count) {
      found.add(drawn.next());
    }
    return List.copyOf(found);
  }

  private static String word(Random random) {
    return syllable(random) + syllable(random) + syllable(random) + syllable(random);
  }

  private static String syllable(Random random) {
    return SYLLABLES[random.nextInt(SYLLABLES.length)];
  }

  List<String> things() {
    return things;
  }

  List<String> titles() {
    return titles;
  }

  /** The evening's home with all of them. */
  Home in(String evening) {
    StringBuilder text = new StringBuilder(evening).append('\n');
    for (int i = 0; i < things.size(); i++) {
      text.append(
          "home:extra-%d a :%s ; rdfs:label \"the %s\"@en ; :colour \"green\" ; :usuallyIn home:%s .\n"
              .formatted(i, KINDS[i % KINDS.length], things.get(i), ROOMS[i / 3 % ROOMS.length]));
    }
    for (int i = 0; i < titles.size(); i++) {
      text.append(
          "home:title-%d a :Track ; rdfs:label \"%s\"@en ; :title \"%s\" ; :by home:TheCure .\n"
              .formatted(i, titles.get(i), titles.get(i)));
    }
    return new HomeLoader().load(text.toString(), "evening.ttl");
  }
}

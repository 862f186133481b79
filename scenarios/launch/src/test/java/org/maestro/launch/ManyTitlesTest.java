package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.language.Language;
import org.maestro.language.reference.Discourse;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.Facts;

/** What is said of a track is not held against each of those that there are. */
class ManyTitlesTest {
  private static final int FEW = 500;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "what is the title of this track",
        "are there other songs by this artist",
        "play another song",
      })
  void asManyQuestionsAreAskedWhateverTheNumberOfTitles(String words) {
    int few = questions(words, FEW);

    assertThat(questions(words, 4 * FEW)).isLessThan(few + FEW);
  }

  private static int questions(String words, int titles) {
    String tracks =
        IntStream.range(0, titles)
            .mapToObj("home:more-%1$d a :Track ; rdfs:label \"Zorbil %1$d\"@en .\n"::formatted)
            .collect(Collectors.joining());
    Home home =
        new HomeLoader()
            .load(Shipped.text("/homes/evening.ttl").orElseThrow() + tracks, "evening.ttl");
    AtomicInteger asked = new AtomicInteger();
    Facts facts = counting(SceneFacts.of(home, Optional.of(Shipped.scene("evening", home))), asked);
    Situation situation =
        new Situation(
            home,
            facts,
            Optional.of("Dave"),
            Optional.of("livingroom"),
            Optional.of("rob"),
            OptionalInt.of(18 * 60 + 5),
            Discourse.NONE);
    SpokenEvening.understood(Language.of(home, "en"), List.of(words.split(" ")), situation);
    return asked.get();
  }

  private static Facts counting(Facts facts, AtomicInteger asked) {
    return (Facts)
        Proxy.newProxyInstance(
            Facts.class.getClassLoader(),
            new Class<?>[] {Facts.class},
            (proxy, method, arguments) -> {
              if (method.getName().equals("truth")) {
                asked.incrementAndGet();
              }
              try {
                return method.invoke(facts, arguments);
              } catch (InvocationTargetException e) {
                throw e.getCause();
              }
            });
  }
}

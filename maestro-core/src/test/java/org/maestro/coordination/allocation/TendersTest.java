package org.maestro.coordination.allocation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.Bid;
import org.maestro.coordination.api.Market;
import org.maestro.coordination.api.Roster;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.sl.Expression;
import org.maestro.sl.Term;

/** Who is called for prices, when, and whose prices count. */
class TendersTest {
  private static final int LAMPS = 30;
  private static final PlanningResult NO_PLAN =
      new PlanningResult.Impossible(new PlanningResult.Explanation(List.of(), true));

  private final Home home = new HomeLoader().load(lamps(LAMPS), "lamps.ttl");
  private final Roster roster = new Roster();

  private static String lamps(int number) {
    StringBuilder text =
        new StringBuilder(
            """
            @prefix : <https://w3id.org/maestro/domain#> .
            @prefix home: <https://w3id.org/maestro/home/lamps#> .
            @prefix maestro: <https://w3id.org/maestro#> .
            <https://w3id.org/maestro/home/lamps> a maestro:Home .
            home:hall a maestro:Room ; maestro:outline "0 0, 9 0, 9 9, 0 9" ; maestro:height 3 .
            home:zone a maestro:Zone ; maestro:outline "0 0, 9 0, 9 9, 0 9" .
            """);
    for (int i = 0; i < number; i++) {
      text.append(
          """
          home:lamp-%d a :Lamp ; maestro:order %d ; maestro:pose "%d.5 4.5 3" ;
            maestro:luminousIntensity 900 ; maestro:beamAngle 100 ; :power 9 .
          """
              .formatted(i, i, i % 9));
    }
    return text.toString();
  }

  private Tenders tenders(int members) {
    Map<String, List<String>> candidates = new LinkedHashMap<>();
    for (int i = 0; i < members; i++) {
      candidates.put("lamp-" + i, List.of("adjustLight"));
      roster.present("lamp-" + i);
    }
    return new Tenders(candidates, roster);
  }

  private FeatureType adjustLight(String lamp) {
    return home.devices().get(lamp).features().stream()
        .filter(feature -> feature.name().equals("adjustLight"))
        .findFirst()
        .orElseThrow();
  }

  private PlanningResult planWith(String lamp, String... contenders) {
    Step step =
        new Step(
            1, lamp, adjustLight(lamp), Map.of("level", new Term.Number(1)), 1, 1, true, Set.of());
    return new PlanningResult.Found(
        new Plan(List.of(step), 1, Map.of()), OptionalDouble.empty(), Set.of(contenders));
  }

  /** A round in which all bid a number, and those named refuse. */
  private record Round(Set<String> members, double price, Set<String> refusing, List<String> awards)
      implements Market.Tender {
    @Override
    public List<Bid> bids() {
      Price stated = new Price.Stated(new Expression.OfTerm(new Term.Number(price)));
      return members.stream()
          .sorted()
          .map(
              member ->
                  refusing.contains(member)
                      ? new Bid(member, Map.of(), Optional.of("busy"))
                      : new Bid(member, Map.of("adjustLight", stated), Optional.empty()))
          .toList();
    }

    @Override
    public void award(Map<String, List<Step>> parts) {
      members.stream().filter(parts::containsKey).forEach(awards::add);
    }
  }

  private List<String> offering(Tenders tenders) {
    return tenders.features(home, new ExactPrices()).stream().map(PricedFeature::member).toList();
  }

  @Test
  void fewAreAllCalledAtOnce() {
    Tenders tenders = tenders(5);

    assertThat(tenders.atFirst()).hasSize(5);
  }

  @Test
  void ofManyOnlyThoseAreCalledWhoCouldTakePartInAPlanNearTheCheapest() {
    Tenders tenders = tenders(LAMPS);
    List<String> awards = new ArrayList<>();

    assertThat(tenders.atFirst()).isEmpty();
    assertThat(offering(tenders)).hasSize(LAMPS);
    Set<String> wanted = tenders.wantedFor(planWith("lamp-3", "lamp-3", "lamp-7"));
    assertThat(wanted).containsExactlyInAnyOrder("lamp-3", "lamp-7");

    tenders.add(wanted, new Round(wanted, 2, Set.of("lamp-7"), awards));
    assertThat(offering(tenders)).hasSize(LAMPS - 1).doesNotContain("lamp-7");
    assertThat(tenders.wantedFor(planWith("lamp-3", "lamp-3", "lamp-5"))).isEmpty();
    assertThat(tenders.notCalled()).isEqualTo(LAMPS - 2);

    Set<String> others = tenders.wantedFor(planWith("lamp-5", "lamp-3", "lamp-5"));
    assertThat(others).containsExactly("lamp-5");
    tenders.add(others, new Round(others, 3, Set.of(), awards));
    tenders.award(Map.of("lamp-3", List.of(), "lamp-5", List.of()));
    assertThat(awards).containsExactly("lamp-3", "lamp-5");
  }

  @Test
  void aBidCountsInPlaceOfTheDescription() {
    Tenders tenders = tenders(LAMPS);
    tenders.add(Set.of("lamp-3"), new Round(Set.of("lamp-3"), 77, Set.of(), new ArrayList<>()));

    assertThat(tenders.features(home, new ExactPrices()))
        .filteredOn(feature -> feature.member().equals("lamp-3"))
        .singleElement()
        .extracting(PricedFeature::price)
        .isEqualTo(new Price.Stated(new Expression.OfTerm(new Term.Number(77))));
  }

  @Test
  void thatThereIsNoPlanIsSaidOnlyWhenAllWereCalled() {
    Tenders tenders = tenders(LAMPS);
    roster.absent("lamp-1", "switched off");

    Set<String> wanted = tenders.wantedFor(NO_PLAN);
    assertThat(wanted).hasSize(LAMPS);
    assertThat(tenders.allCalled()).isFalse();
    assertThat(offering(tenders)).doesNotContain("lamp-1");

    tenders.add(wanted, new Round(Set.of(), 1, Set.of(), new ArrayList<>()));
    assertThat(tenders.allCalled()).isTrue();
    assertThat(tenders.wantedFor(NO_PLAN)).isEmpty();
    assertThat(tenders.missing()).hasSize(LAMPS);
  }
}

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
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Proposal;
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
class CandidateProposalsTest {
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

  private CandidateProposals proposals(int members) {
    Map<String, List<String>> candidates = new LinkedHashMap<>();
    for (int i = 0; i < members; i++) {
      candidates.put("lamp-" + i, List.of("adjustLight"));
      roster.present("lamp-" + i);
    }
    return new CandidateProposals(candidates, roster);
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
      implements ContractNet.Round {
    @Override
    public List<Proposal> bids() {
      Price stated = new Price.Stated(new Expression.OfTerm(new Term.Number(price)));
      return members.stream()
          .sorted()
          .map(
              member ->
                  refusing.contains(member)
                      ? new Proposal(member, Map.of(), Optional.of("busy"))
                      : new Proposal(member, Map.of("adjustLight", stated), Optional.empty()))
          .toList();
    }

    @Override
    public void award(Map<String, List<Step>> parts) {
      members.stream().filter(parts::containsKey).forEach(awards::add);
    }
  }

  private List<String> offering(CandidateProposals proposals) {
    return proposals.features(home, new ExactPrices()).stream().map(PricedFeature::member).toList();
  }

  @Test
  void fewAreAllCalledAtOnce() {
    CandidateProposals proposals = proposals(5);

    assertThat(proposals.atFirst()).hasSize(5);
  }

  @Test
  void ofManyOnlyThoseAreCalledWhoCouldTakePartInAPlanNearTheCheapest() {
    CandidateProposals proposals = proposals(LAMPS);
    List<String> awards = new ArrayList<>();

    assertThat(proposals.atFirst()).isEmpty();
    assertThat(offering(proposals)).hasSize(LAMPS);
    Set<String> wanted = proposals.wantedFor(planWith("lamp-3", "lamp-3", "lamp-7"));
    assertThat(wanted).containsExactlyInAnyOrder("lamp-3", "lamp-7");

    proposals.add(wanted, new Round(wanted, 2, Set.of("lamp-7"), awards));
    assertThat(offering(proposals)).hasSize(LAMPS - 1).doesNotContain("lamp-7");
    assertThat(proposals.wantedFor(planWith("lamp-3", "lamp-3", "lamp-5"))).isEmpty();
    assertThat(proposals.notCalled()).isEqualTo(LAMPS - 2);

    Set<String> others = proposals.wantedFor(planWith("lamp-5", "lamp-3", "lamp-5"));
    assertThat(others).containsExactly("lamp-5");
    proposals.add(others, new Round(others, 3, Set.of(), awards));
    proposals.award(Map.of("lamp-3", List.of(), "lamp-5", List.of()));
    assertThat(awards).containsExactly("lamp-3", "lamp-5");
  }

  @Test
  void aBidCountsInPlaceOfTheDescription() {
    CandidateProposals proposals = proposals(LAMPS);
    proposals.add(Set.of("lamp-3"), new Round(Set.of("lamp-3"), 77, Set.of(), new ArrayList<>()));

    assertThat(proposals.features(home, new ExactPrices()))
        .filteredOn(feature -> feature.member().equals("lamp-3"))
        .singleElement()
        .extracting(PricedFeature::price)
        .isEqualTo(new Price.Stated(new Expression.OfTerm(new Term.Number(77))));
  }

  @Test
  void thatThereIsNoPlanIsSaidOnlyWhenAllWereCalled() {
    CandidateProposals proposals = proposals(LAMPS);
    roster.absent("lamp-1", "switched off");

    Set<String> wanted = proposals.wantedFor(NO_PLAN);
    assertThat(wanted).hasSize(LAMPS);
    assertThat(proposals.allCalled()).isFalse();
    assertThat(offering(proposals)).doesNotContain("lamp-1");

    proposals.add(wanted, new Round(Set.of(), 1, Set.of(), new ArrayList<>()));
    assertThat(proposals.allCalled()).isTrue();
    assertThat(proposals.wantedFor(NO_PLAN)).isEmpty();
    assertThat(proposals.missing()).hasSize(LAMPS);
  }
}

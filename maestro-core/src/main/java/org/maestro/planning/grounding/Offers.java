package org.maestro.planning.grounding;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.problem.ChainCosts;
import org.maestro.planning.problem.Departure;
import org.maestro.planning.problem.Signature;
import org.maestro.planning.problem.Variable;
import org.maestro.planning.problem.VariableValue;
import org.maestro.sl.EffectTarget;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Self;
import org.maestro.sl.Term;

/** The features of a task by number. A feature keeps its number while others come and go. */
final class Offers {
  private record Name(String member, String feature) {}

  private final List<PricedFeature> features = new ArrayList<>();
  private final List<Integer> families = new ArrayList<>();
  private final IdentityHashMap<FeatureType, Set<String>> addedBy = new IdentityHashMap<>();
  private final IdentityHashMap<FeatureType, Set<String>> sensedBy = new IdentityHashMap<>();
  private final Predicate<String> isSymmetric;
  private final Map<String, Changing> changing = new HashMap<>();
  private final Map<Integer, Integer> ranks = new HashMap<>();
  private final Set<String> removed = new HashSet<>();

  /**
   * The features that may change one predicate or number, each in the task's order.
   *
   * @param ofItself those that change only what names their member itself, such as where it is: by
   *     the place of that argument, and by the member
   */
  private record Changing(
      List<Integer> ofAnything, Map<Integer, Map<String, List<Integer>>> ofItself) {}

  /**
   * @param isSymmetric tells whether the arguments of a predicate may be swapped
   */
  Offers(List<PricedFeature> features, Predicate<String> isSymmetric) {
    this.isSymmetric = isSymmetric;
    become(features);
  }

  /**
   * Takes these, in their order; equal ones keep their numbers, others get new ones.
   *
   * @return the numbers of those that went while one of the same family came: they have other
   *     prices now
   */
  final Set<Integer> become(List<PricedFeature> next) {
    Set<Integer> before = there();
    Map<Name, List<Integer>> known = new HashMap<>();
    for (int i = 0; i < features.size(); i++) {
      known.computeIfAbsent(name(features.get(i)), absent -> new ArrayList<>()).add(i);
    }
    changing.clear();
    ranks.clear();
    removed.clear();
    IdentityHashMap<FeatureType, Map<String, OptionalInt>> changedBy = new IdentityHashMap<>();
    for (PricedFeature feature : next) {
      int number = number(feature, known.getOrDefault(name(feature), List.of()));
      ranks.put(number, ranks.size());
      changedBy
          .computeIfAbsent(feature.type(), this::changedBy)
          .forEach((name, ownPlace) -> add(name, ownPlace, feature.member(), number));
    }
    changedBy.keySet().forEach(type -> removed.addAll(Signature.removedBy(type.effect())));
    Set<Integer> familiesThere = new HashSet<>();
    ranks.keySet().forEach(number -> familiesThere.add(families.get(number)));
    return before.stream()
        .filter(number -> !isThere(number) && familiesThere.contains(families.get(number)))
        .collect(Collectors.toSet());
  }

  /** What a feature may change, and which argument is always the member itself, if any is. */
  private Map<String, OptionalInt> changedBy(FeatureType type) {
    Map<String, List<EffectTarget>> targets = new LinkedHashMap<>();
    for (EffectTarget target : EffectTarget.of(type.effect())) {
      targets.computeIfAbsent(target.name(), absent -> new ArrayList<>()).add(target);
    }
    Map<String, OptionalInt> ownPlaces = new LinkedHashMap<>();
    targets.forEach(
        (name, all) ->
            ownPlaces.put(
                name,
                isSymmetric.test(name)
                    ? OptionalInt.empty()
                    : IntStream.range(0, all.get(0).arguments().size())
                        .filter(place -> all.stream().allMatch(t -> isOwn(t, place)))
                        .findFirst()));
    return ownPlaces;
  }

  private static boolean isOwn(EffectTarget target, int place) {
    return place < target.arguments().size() && target.arguments().get(place).equals(Self.VARIABLE);
  }

  private void add(String name, OptionalInt ownPlace, String member, int number) {
    Changing all =
        changing.computeIfAbsent(name, absent -> new Changing(new ArrayList<>(), new TreeMap<>()));
    List<Integer> numbers =
        ownPlace.isEmpty()
            ? all.ofAnything()
            : all.ofItself()
                .computeIfAbsent(ownPlace.getAsInt(), absent -> new HashMap<>())
                .computeIfAbsent(member, absent -> new ArrayList<>());
    numbers.add(number);
  }

  private static Name name(PricedFeature feature) {
    return new Name(feature.member(), feature.type().name());
  }

  @SuppressWarnings("ReferenceEquality") // A type is told by its object, as in addedBy.
  private int number(PricedFeature feature, List<Integer> known) {
    for (int number : known) {
      if (!ranks.containsKey(number) && features.get(number).equals(feature)) {
        return number;
      }
    }
    int number = features.size();
    families.add(
        known.stream()
            .filter(other -> features.get(other).type() == feature.type())
            .filter(other -> pricedBy(features.get(other)).equals(pricedBy(feature)))
            .findFirst()
            .map(families::get)
            .orElse(number));
    features.add(feature);
    return number;
  }

  private static Set<String> pricedBy(PricedFeature feature) {
    return FreeVariables.of(FeatureTemplate.statedPrice(feature));
  }

  /**
   * The same for features that differ only in prices, and these in no more than numbers: their
   * instances are the same steps.
   */
  int family(int number) {
    return families.get(number);
  }

  /** The numbers of all that are there now. */
  Set<Integer> there() {
    return Set.copyOf(ranks.keySet());
  }

  /** How many numbers there are, of features that went too. */
  int numbers() {
    return features.size();
  }

  PricedFeature feature(int number) {
    return features.get(number);
  }

  /** Whether the feature is of the task now. */
  boolean isThere(int number) {
    return ranks.containsKey(number);
  }

  /** The places in the task's order of all that are there, by their numbers. */
  Map<Integer, Integer> ranks() {
    return Map.copyOf(ranks);
  }

  /** The place in the task's order of a feature that is there. */
  int rank(int number) {
    return Objects.requireNonNull(ranks.get(number));
  }

  /**
   * Numbers of the features that may bring about or change what is wanted, in the task's order. Who
   * changes only what names itself is none of them where another is named.
   *
   * @param name of the predicate or number
   * @param arguments as far as they are known
   * @param among tells which of those that may change something else too may change this
   */
  List<Integer> changing(String name, List<Term> arguments, UnaryOperator<List<Integer>> among) {
    Changing all = changing.get(name);
    if (all == null) {
      return List.of();
    }
    List<Integer> numbers = new ArrayList<>(among.apply(all.ofAnything()));
    numbers.removeIf(number -> !isThere(number));
    all.ofItself()
        .forEach(
            (place, byMember) -> {
              if (place >= arguments.size()) {
                byMember.values().forEach(numbers::addAll);
              } else if (arguments.get(place) instanceof Term.Name member) {
                numbers.addAll(byMember.getOrDefault(member.text(), List.of()));
              }
            });
    numbers.sort(Comparator.comparingInt(this::rank));
    return numbers;
  }

  /** Whether a feature of the type may do it: only what is not known can be found. */
  boolean mayBringAbout(FeatureType type, Object want) {
    String predicate =
        ChainCosts.target(want) instanceof Variable variable ? variable.predicate() : "";
    boolean mayBeUnknown = removed.contains(predicate);
    if (want instanceof Departure) {
      return mayBeUnknown || mayAdd(type, predicate);
    }
    return !(want instanceof VariableValue aim)
        || mayAdd(type, predicate)
        || (aim.isFindable() || mayBeUnknown) && maySense(type, predicate);
  }

  private boolean mayAdd(FeatureType type, String predicate) {
    return addedBy
        .computeIfAbsent(type, absent -> Signature.addedBy(type.effect()))
        .contains(predicate);
  }

  private boolean maySense(FeatureType type, String predicate) {
    return sensedBy
        .computeIfAbsent(type, absent -> Signature.sensedBy(type.effect()))
        .contains(predicate);
  }
}

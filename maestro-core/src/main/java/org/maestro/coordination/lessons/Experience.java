package org.maestro.coordination.lessons;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.api.Unavailable;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;

/**
 * The lessons of steps about members, beyond their descriptions and for all goals of a coordinator:
 * features of which the results teach nothing again and again, and conditions that members insist
 * on. Forgotten when the member describes itself anew. The coordinator's thread only.
 */
public final class Experience {
  /** So many results in a row may teach nothing. */
  private static final int MOST_USELESS = 3;

  private record Key(String member, String feature) {}

  private record Useless(int inARow, String latest) {}

  private final Map<Key, Useless> useless = new HashMap<>();
  private final Map<Key, List<Insistence>> insisted = new HashMap<>();

  /**
   * A result taught nothing.
   *
   * @param problem one sentence without its full stop
   */
  public void taughtNothing(String member, String feature, String problem) {
    useless.merge(
        new Key(member, feature),
        new Useless(1, problem),
        (before, now) -> new Useless(before.inARow() + 1, now.latest()));
  }

  /** A result was as described. */
  public void taught(String member, String feature) {
    useless.remove(new Key(member, feature));
  }

  /**
   * A step was refused, or failed, and its member named what it needs.
   *
   * @param known for the limits that the description names
   * @return what was not known before
   */
  public List<Insistence> refused(
      StepKey step, FeatureType feature, List<FeatureRun.Learnt> refs, Facts known) {
    List<Insistence> news = new ArrayList<>();
    for (FeatureRun.Learnt ref : refs) {
      Insistence.of(step, feature, ref, known).ifPresent(news::add);
    }
    List<Insistence> all =
        insisted.computeIfAbsent(new Key(step.member(), step.feature()), key -> new ArrayList<>());
    news.removeIf(
        insistence -> all.stream().anyMatch(k -> k.condition().equals(insistence.condition())));
    for (Insistence insistence : news) {
      all.removeIf(former -> former.isRenewedBy(insistence));
      all.add(insistence);
    }
    return news;
  }

  /** Whether the member insists on more for the feature than it has described. */
  public boolean isInsistedOn(String member, String feature) {
    return !insisted.getOrDefault(new Key(member, feature), List.of()).isEmpty();
  }

  /** The member has described itself anew; what was before says nothing any more. */
  public void forget(String member) {
    useless.keySet().removeIf(key -> key.member().equals(member));
    insisted.keySet().removeIf(key -> key.member().equals(member));
  }

  /** Why the feature is left alone; empty when it is not. */
  Optional<String> leftAlone(String member, String feature) {
    return Optional.ofNullable(useless.get(new Key(member, feature)))
        .filter(known -> known.inARow() >= MOST_USELESS)
        .map(
            known ->
                "it is not asked for %s any more, after %d results in a row that taught nothing: %s"
                    .formatted(feature, known.inARow(), known.latest()));
  }

  /** Whether any feature of the member is left alone. */
  public boolean isDoubted(String member) {
    return useless.keySet().stream()
        .filter(key -> key.member().equals(member))
        .anyMatch(key -> leftAlone(member, key.feature()).isPresent());
  }

  /** What of this can be counted on, with what is insisted on. */
  public List<PricedFeature> reliable(List<PricedFeature> offered) {
    return offered.stream()
        .filter(f -> leftAlone(f.member(), f.type().name()).isEmpty())
        .map(this::withWhatIsInsistedOn)
        .toList();
  }

  private PricedFeature withWhatIsInsistedOn(PricedFeature offered) {
    FeatureType type = offered.type();
    return isInsistedOn(offered.member(), type.name())
        ? new PricedFeature(
            offered.member(),
            type.withPrecondition(condition(offered.member(), type)),
            offered.price(),
            offered.exact())
        : offered;
  }

  /** What the feature needs, by its description and by what its member insists on. */
  public Formula condition(String member, FeatureType type) {
    List<Formula> conditions = new ArrayList<>(List.of(type.precondition()));
    insisted
        .getOrDefault(new Key(member, type.name()), List.of())
        .forEach(insistence -> conditions.add(insistence.condition()));
    return new Formula.And(conditions);
  }

  /** What of this cannot be counted on, each with its reason. */
  public List<Unavailable> unreliable(List<PricedFeature> offered) {
    List<Unavailable> left = new ArrayList<>();
    for (PricedFeature feature : offered) {
      leftAlone(feature.member(), feature.type().name())
          .ifPresent(why -> left.add(new Unavailable(feature, why)));
    }
    return left;
  }
}

package org.maestro.device.tasks;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.maestro.hal.Area;
import org.maestro.hal.Completion;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.member.Execution;
import org.maestro.rats.protocol.RatsError;

/**
 * Puts down what the hand holds, beside a thing, in an area, on a thing with a top, or into a
 * container: approach, reach out, let go, fold (Three-layered architecture, 3.2; M29).
 */
final class PlaceTask extends ArmTask {

  private static final String TOP = "topHeight";

  /** Of a mere point nothing else is known; of a body it is, such as its size. */
  private static final Set<String> OF_POINTS = Set.of("position");

  /** It comes after a body that walks on so many times. */
  private static final int APPROACHES = 3;

  /** A body that has moved farther than this is approached anew; metres. */
  private static final double MOVED_METRES = 0.1;

  private final boolean into;

  /**
   * @param into whether the target is a container, into which the hand reaches
   */
  PlaceTask(FeatureContext context, boolean into) {
    super(context);
    this.into = into;
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    Pointer object = parameters.pointer("object");
    Pointer target = parameters.pointer("target");
    if (!arm().held().equals(Optional.of(object.name()))) {
      execution.fail(notHeld(parameters, "The hand does not hold " + object.name() + "."));
      return;
    }
    Optional<FollowedBody> body = body(target);
    if (ways(target, body).isEmpty()) {
      throw new InvalidCallException(
          "The pointer target comes without position and is no area of the map.");
    }
    exitSafely(execution);
    AtomicReference<@Nullable Position> spot = new AtomicReference<>();
    new ActionSequence(
            context().device(),
            execution,
            List.of(
                approach(target, body, spot),
                new ActionSequence.Action(
                    "look",
                    completion -> look(target, body, chosen(spot), completion),
                    reason -> left(object, target, reason)),
                new ActionSequence.Action(
                    "reach out", completion -> arm().extend(chosen(spot), completion)),
                new ActionSequence.Action(
                    "feel the place", this::feel, reason -> occupied(object, target, reason)),
                new ActionSequence.Action(
                    "let go", arm()::release, reason -> lost(object, parameters, reason)),
                new ActionSequence.Action("fold", arm()::fold)),
            () -> {
              context().deposits().put(object.name(), chosen(spot));
              execution.succeed(Map.of());
            })
        .run();
  }

  private ActionSequence.Action approach(
      Pointer target, Optional<FollowedBody> body, AtomicReference<@Nullable Position> spot) {
    ActionSequence.Action once =
        approach(
            reach -> ways(target, body).orElseThrow().apply(reach),
            point -> spot.set(new Position(point.x(), point.y(), height(target).orElse(0))),
            "Cannot place at " + target.name());
    return body.isEmpty()
        ? once
        : new ActionSequence.Action(
            once.name(),
            completion -> follow(body.get(), once.command(), APPROACHES, completion),
            once.failure());
  }

  private static void follow(
      FollowedBody body, ActionSequence.Command approach, int times, Completion completion) {
    Point2 before = body.place().floor();
    approach.start(
        new Completion() {
          @Override
          public void done() {
            if (times > 1 && body.place().floor().distance(before) > MOVED_METRES) {
              follow(body, approach, times - 1, completion);
            } else {
              completion.done();
            }
          }

          @Override
          public void failed(String reason) {
            completion.failed(reason);
          }
        });
  }

  /** Whether the body beside which something is to stand is there. */
  private static void look(
      Pointer target, Optional<FollowedBody> body, Position spot, Completion completion) {
    if (body.filter(FollowedBody::isGone).isPresent()) {
      completion.failed(target.name() + " is not there any more");
    } else if (body.filter(it -> !isBeside(it.place(), spot)).isPresent()) {
      completion.failed(target.name() + " walks on");
    } else {
      completion.done();
    }
  }

  private static boolean isBeside(Position body, Position spot) {
    return body.floor().distance(spot.floor()) <= Reach.GREATEST_DISTANCE + MOVED_METRES;
  }

  private static RatsError left(Pointer object, Pointer target, String reason) {
    return FeatureContext.unmet(
        "Cannot place %s at %s: %s.".formatted(object.name(), target.name(), reason),
        "look for %s again".formatted(target.name()),
        List.of());
  }

  private Optional<FollowedBody> body(Pointer target) {
    return into || height(target).isPresent() || OF_POINTS.containsAll(target.properties().keySet())
        ? Optional.empty()
        : context().deposits().position(target).map(told -> new FollowedBody(robot(), told));
  }

  /** The approach, which comes first, has chosen it. */
  private static Position chosen(AtomicReference<@Nullable Position> spot) {
    return Objects.requireNonNull(spot.get());
  }

  private void feel(Completion completion) {
    if (arm().isPlaceFree()) {
      completion.done();
    } else {
      completion.failed("something stands there already");
    }
  }

  private static RatsError occupied(Pointer object, Pointer target, String reason) {
    return FeatureContext.unmet(
        "Cannot place %s at %s: %s.".formatted(object.name(), target.name(), reason),
        "clear the place",
        List.of());
  }

  /** Somebody took it on the way: a hand feels that. */
  private RatsError lost(Pointer object, CallParameters parameters, String reason) {
    return arm().held().isPresent()
        ? FeatureContext.broken(reason)
        : notHeld(parameters, "The hand does not hold " + object.name() + " any more.");
  }

  private RatsError notHeld(CallParameters parameters, String sentence) {
    return FeatureContext.unmet(
        sentence,
        "pick it up first",
        context().reference("holding", parameters, Map.of(), "true", false).stream().toList());
  }

  /**
   * Empty when the target can be nowhere; what is found by asking is empty when there is no free
   * spot or way.
   */
  private Optional<Function<Reach, Optional<Reach.Approach>>> ways(
      Pointer target, Optional<FollowedBody> body) {
    Optional<Area> area =
        target
            .outline()
            .map(outline -> new Area(target.name(), outline, outline.centroid()))
            .or(() -> robot().area(target.name()));
    if (area.isPresent()) {
      return Optional.of(reach -> reach.within(area.get()));
    }
    return body.map(FollowedBody::place)
        .or(() -> context().deposits().position(target))
        .map(
            place ->
                reach ->
                    height(target).isPresent()
                        ? reach.to(place.floor())
                        : reach.beside(place.floor()));
  }

  /** How high above the floor things stand on or in the target, if it is one for that. */
  private OptionalDouble height(Pointer target) {
    return into
        ? target.position().map(place -> OptionalDouble.of(place.z())).orElse(OptionalDouble.of(0))
        : target.number(TOP);
  }

  @Override
  public boolean isPossibleNow() {
    return arm().held().isPresent();
  }

  @Override
  Estimate cost(CallParameters parameters) {
    Pointer target = parameters.pointer("target");
    return ways(target, body(target))
        .map(approach -> price(approach, arm().placeSeconds(), target.name()))
        .orElseGet(() -> price(arm().placeSeconds()));
  }
}

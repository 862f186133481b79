package org.maestro.device.tasks;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.maestro.hal.Area;
import org.maestro.hal.Completion;
import org.maestro.hal.Position;
import org.maestro.rats.member.Execution;
import org.maestro.rats.protocol.RatsError;

/**
 * Puts down what the hand holds, beside a thing, in an area, on a thing with a top, or into a
 * container: approach, reach out, let go, fold (Three-layered architecture, 3.2; M29).
 */
final class PlaceTask extends ArmTask {

  private static final String TOP = "topHeight";

  /** What has a size is a body, which is seen where it stands; a mere point has none. */
  private static final String SIZE = "size";

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
    if (ways(target).isEmpty()) {
      throw new InvalidCallException(
          "The pointer target comes without position and is no area of the map.");
    }
    exitSafely(execution);
    AtomicReference<@Nullable Position> spot = new AtomicReference<>();
    new ActionSequence(
            context().device(),
            execution,
            List.of(
                approach(target, spot),
                new ActionSequence.Action(
                    "look",
                    completion -> look(target, chosen(spot), completion),
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

  private ActionSequence.Action approach(Pointer target, AtomicReference<@Nullable Position> spot) {
    ActionSequence.Action once =
        approach(
            reach -> ways(target).orElseThrow().apply(reach),
            point -> spot.set(new Position(point.x(), point.y(), height(target).orElse(0))),
            "Cannot place at " + target.name());
    return new ActionSequence.Action(
        once.name(),
        completion -> follow(target, once.command(), APPROACHES, completion),
        once.failure());
  }

  private void follow(
      Pointer target, ActionSequence.Command approach, int times, Completion completion) {
    Optional<Position> before = place(target);
    approach.start(
        new Completion() {
          @Override
          public void done() {
            if (times > 1 && place(target).filter(now -> isApart(before, now)).isPresent()) {
              follow(target, approach, times - 1, completion);
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

  private static boolean isApart(Optional<Position> before, Position now) {
    return before.filter(then -> then.floor().distance(now.floor()) > MOVED_METRES).isPresent();
  }

  /** Whether the body beside which something is to stand is there. */
  private void look(Pointer target, Position spot, Completion completion) {
    Optional<Position> place = place(target);
    if (!isBody(target) || place.filter(robot().surroundings()::sees).isEmpty()) {
      completion.done();
    } else if (robot().seen(target.name()).isEmpty()) {
      completion.failed(target.name() + " is not there any more");
    } else if (place.get().floor().distance(spot.floor())
        > Reach.GREATEST_DISTANCE + MOVED_METRES) {
      completion.failed(target.name() + " walks on");
    } else {
      completion.done();
    }
  }

  private static RatsError left(Pointer object, Pointer target, String reason) {
    return FeatureContext.unmet(
        "Cannot place %s at %s: %s.".formatted(object.name(), target.name(), reason),
        "look for %s again".formatted(target.name()),
        List.of());
  }

  private boolean isBody(Pointer target) {
    return !into && height(target).isEmpty() && target.properties().containsKey(SIZE);
  }

  /** Where the robot sees it itself, else where the caller knows it to be. */
  private Optional<Position> place(Pointer target) {
    return Optional.of(target)
        .filter(this::isBody)
        .flatMap(body -> robot().seen(body.name()))
        .map(Position::onFloor)
        .or(() -> context().deposits().position(target));
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
  private Optional<Function<Reach, Optional<Reach.Approach>>> ways(Pointer target) {
    Optional<Area> area =
        target
            .outline()
            .map(outline -> new Area(target.name(), outline, outline.centroid()))
            .or(() -> robot().area(target.name()));
    if (area.isPresent()) {
      return Optional.of(reach -> reach.within(area.get()));
    }
    return place(target)
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
    return ways(target)
        .map(approach -> price(approach, arm().placeSeconds(), target.name()))
        .orElseGet(() -> price(arm().placeSeconds()));
  }
}

package org.maestro.device.tasks;

import java.util.List;
import java.util.Map;
import org.maestro.hal.Position;
import org.maestro.rats.member.Execution;

/**
 * Picks something up: approach, open the hand, reach out, grasp, fold (Three-layered architecture,
 * 3.2; M29).
 */
final class PickTask extends ArmTask {

  private final String where;

  /**
   * @param where the parameter that tells where it is: the object itself, or a container
   */
  PickTask(FeatureContext context, String where) {
    super(context);
    this.where = where;
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    Pointer object = parameters.pointer("object");
    Position place =
        context()
            .deposits()
            .position(parameters.pointer(where))
            .orElseThrow(
                () ->
                    new InvalidCallException(
                        "The pointer %s comes without position, so that nobody can grasp there."
                            .formatted(where)));
    if (arm().held().isPresent()) {
      execution.fail(
          FeatureContext.unmet(
              "The hand holds " + arm().held().get() + " already.",
              "place it first",
              context().reference("hand", parameters, Map.of(), "true", false).stream().toList()));
      return;
    }
    exitSafely(execution);
    new ActionSequence(
            context().device(),
            execution,
            List.of(
                approach(
                    reach -> reach.to(place.floor()),
                    spot -> {},
                    "Cannot drive to " + object.name()),
                new ActionSequence.Action("open hand", arm()::open),
                new ActionSequence.Action(
                    "reach out", completion -> arm().extend(place, completion)),
                new ActionSequence.Action(
                    "grasp",
                    completion -> arm().grasp(object.target(), completion),
                    reason ->
                        FeatureContext.unmet(
                            "Cannot grasp " + object.name() + ": " + reason + ".",
                            "look for it again, or let another robot take it",
                            List.of())),
                new ActionSequence.Action("fold", arm()::fold)),
            () -> {
              context().deposits().forget(object.name());
              execution.succeed(Map.of());
            })
        .run();
  }

  @Override
  public boolean isPossibleNow() {
    return arm().held().isEmpty();
  }

  @Override
  Estimate cost(CallParameters parameters) {
    Pointer object = parameters.pointer("object");
    return context()
        .deposits()
        .position(parameters.pointer(where))
        .map(place -> price(reach -> reach.to(place.floor()), arm().pickSeconds(), object.name()))
        .orElseGet(() -> price(arm().pickSeconds()));
  }
}

package org.maestro.hal;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;

/**
 * A face that pages in browsers draw, which is at once as it is told to be; where no page shows it
 * it can do nothing, as a head without power. The clock's thread only.
 */
public final class PageFace implements Face {
  /** As long as the page takes to move a head once. */
  private static final double GESTURE_SECONDS = 0.9;

  private static final double POINTING_SECONDS = 2;

  private final String id;
  private final FaceMount mount;
  private final BooleanSupplier isShown;
  private final Pace pace;
  private final Runnable changed;
  private FaceState state = FaceState.AT_REST;

  /** Goes on after some seconds. */
  public interface Pace {
    void after(double seconds, Runnable next);
  }

  /**
   * @param id the screen's, by which pages show it
   * @param isShown whether a page shows it now
   * @param changed run each time that it is otherwise than before
   */
  public PageFace(
      String id, FaceMount mount, BooleanSupplier isShown, Pace pace, Runnable changed) {
    this.id = id;
    this.mount = mount;
    this.isShown = isShown;
    this.pace = pace;
    this.changed = changed;
  }

  @Override
  public FaceState state() {
    return state;
  }

  @Override
  public void appear(String persona, Completion completion) {
    show(state.of(persona), completion);
  }

  @Override
  public void express(FacialExpression expression, double intensity, Completion completion) {
    show(state.with(expression, intensity), completion);
  }

  @Override
  public void look(String thing, Position at, Completion completion) {
    show(state.looking(Optional.of(mount.towards(thing, at))), completion);
  }

  @Override
  public void gesture(HeadGesture gesture, Completion completion) {
    showFor(
        GESTURE_SECONDS,
        state.moving(Optional.of(gesture)),
        () -> state.moving(Optional.empty()),
        completion);
  }

  @Override
  public void point(String thing, Position at, Completion completion) {
    showFor(
        POINTING_SECONDS,
        state.pointing(Optional.of(mount.towards(thing, at))),
        () -> state.pointing(Optional.empty()),
        completion);
  }

  @Override
  public void say(String text, double stress, Completion completion) {
    showFor(
        seconds(text, stress),
        state.saying(Optional.of(new FaceState.Spoken(text, stress))),
        () -> state.saying(Optional.empty()),
        completion);
  }

  private void show(FaceState next, Completion completion) {
    if (isShown(completion)) {
      become(next);
      completion.done();
    }
  }

  /** Who looks away meanwhile has seen the beginning only. */
  private void showFor(
      double seconds, FaceState next, Supplier<FaceState> then, Completion completion) {
    if (isShown(completion)) {
      become(next);
      pace.after(
          seconds,
          () -> {
            become(then.get());
            if (isShown(completion)) {
              completion.done();
            }
          });
    }
  }

  private boolean isShown(Completion completion) {
    boolean isSeen = isShown.getAsBoolean();
    if (!isSeen) {
      completion.failed("no page shows this face; open face.html#%s of the console".formatted(id));
    }
    return isSeen;
  }

  private void become(FaceState next) {
    state = next;
    changed.run();
  }
}

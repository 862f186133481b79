package org.maestro.sim.drivers;

import java.util.function.Predicate;

/**
 * The pages that draw faces, as far as their drivers know of them. Until somebody tells better, as
 * the console does, somebody is taken to look at every face. Any thread may use it.
 */
public final class FacePages {
  private volatile Predicate<String> isShown = device -> true;

  /**
   * @param shown whether a page shows the face of that device now
   */
  public void become(Predicate<String> shown) {
    isShown = shown;
  }

  boolean show(String device) {
    return isShown.test(device);
  }
}

package org.maestro.hal;

/** A hand that is a {@link JammingGripper}: it presses, evacuates, and lets go by pressure. */
public final class JammingHand implements Hand {

  private final JammingGripper gripper;

  public JammingHand(JammingGripper gripper) {
    this.gripper = gripper;
  }

  /**
   * A bag that gripped in vain, or lost what it held, is stiff still; that nothing falls out of it
   * is as it should be.
   */
  @Override
  public void open(Completion completion) {
    if (gripper.pressure() < 0) {
      gripper.inflate(
          new Completion() {
            @Override
            public void done() {
              completion.done();
            }

            @Override
            public void failed(String reason) {
              completion.done();
            }
          });
    } else {
      completion.done();
    }
  }

  @Override
  public void close(Completion completion) {
    gripper.press(
        new Completion() {
          @Override
          public void done() {
            gripper.evacuate(completion);
          }

          @Override
          public void failed(String reason) {
            completion.failed(reason);
          }
        });
  }

  @Override
  public void letGo(Completion completion) {
    gripper.inflate(completion);
  }

  @Override
  public void stop() {
    gripper.stop();
  }

  @Override
  public double opening() {
    return gripper.opening();
  }

  @Override
  public double closeSeconds() {
    return gripper.gripSeconds();
  }

  @Override
  public double letGoSeconds() {
    return gripper.inflateSeconds();
  }
}

package org.maestro.device.tasks;

import java.time.Duration;
import java.util.Map;
import org.maestro.hal.Camera;
import org.maestro.hal.Photo;
import org.maestro.rats.member.Execution;

/**
 * Streams what a camera has in view until ended (ADE, 3.3; A44): small pictures without loss, such
 * that each fits into a message.
 */
final class StreamPictures extends DeviceProcedure {
  private static final double SECONDS = 0.1;
  private static final int USUAL_WIDTH = 160;
  private static final int LEAST_WIDTH = 32;

  /** A square one of that width still fits into a message. */
  private static final int MOST_WIDTH = 240;

  private final FeatureContext context;
  private final Camera camera;

  StreamPictures(FeatureContext context) {
    this.context = context;
    this.camera = context.driver(Camera.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    int width = width(parameters);
    Duration period = Streams.period(context.feature(), parameters);
    execution.established(Map.of("width", width));
    take(execution, width, period);
  }

  private static int width(CallParameters parameters) {
    double width = parameters.optionalNumber("width").orElse(USUAL_WIDTH);
    if (width < LEAST_WIDTH || width > MOST_WIDTH) {
      throw new InvalidCallException(
          "The parameter width lies between %d and %d pixels, but is %s."
              .formatted(LEAST_WIDTH, MOST_WIDTH, width));
    }
    return (int) width;
  }

  private void take(Execution execution, int width, Duration period) {
    if (execution.ended()) {
      return;
    }
    Duration begun = context.clock().now();
    camera.photograph(
        width,
        new Camera.PhotoListener() {
          @Override
          public void taken(Photo photo) {
            execution.streamed(context.clock().now(), PngImage.MEDIA_TYPE, PngImage.of(photo));
            Streams.next(context, begun, period, () -> take(execution, width, period));
          }

          @Override
          public void failed(String reason) {
            execution.fail(FeatureContext.broken(reason));
          }
        });
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, 0);
  }
}

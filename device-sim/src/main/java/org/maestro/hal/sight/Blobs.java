package org.maestro.hal.sight;

import boofcv.alg.filter.binary.BinaryImageOps;
import boofcv.concurrency.BoofConcurrency;
import boofcv.struct.ConnectRule;
import boofcv.struct.image.GrayS32;
import boofcv.struct.image.GrayU8;
import java.util.ArrayList;
import java.util.List;

/** Finds what hangs together among the pixels that have a colour. */
final class Blobs {

  static {
    // pictures are small: threads of its own would cost more than they bring
    BoofConcurrency.USE_CONCURRENT = false;
  }

  private Blobs() {}

  /**
   * @param coloured 1 for each pixel that has the colour, 0 for the others
   * @param fewest pixels of a blob
   */
  static List<Blob> of(GrayU8 coloured, int fewest) {
    // noise makes holes: what is left of a thing is to hang together
    GrayU8 closed = BinaryImageOps.erode8(BinaryImageOps.dilate8(coloured, 1, null), 1, null);
    GrayS32 labels = new GrayS32(coloured.width, coloured.height);
    int count = BinaryImageOps.contour(closed, ConnectRule.EIGHT, labels).size();
    int[] pixels = new int[count + 1];
    double[] columns = new double[count + 1];
    double[] rows = new double[count + 1];
    for (int row = 0; row < labels.height; row++) {
      for (int column = 0; column < labels.width; column++) {
        int label = labels.unsafe_get(column, row);
        pixels[label]++;
        columns[label] += column;
        rows[label] += row;
      }
    }
    List<Blob> blobs = new ArrayList<>();
    for (int label = 1; label <= count; label++) {
      if (pixels[label] >= fewest) {
        blobs.add(
            new Blob(pixels[label], columns[label] / pixels[label], rows[label] / pixels[label]));
      }
    }
    return blobs;
  }
}

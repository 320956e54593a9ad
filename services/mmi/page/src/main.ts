import './style/page.css';
import './style/header.css';
import './style/panels.css';
import './style/drawing.css';
import './style/drive.css';
import './style/health.css';
import './style/log.css';
import './style/operate.css';
import 'uplot/dist/uPlot.min.css';
import './elements/app.js';
import {start} from './session.js';

start();
